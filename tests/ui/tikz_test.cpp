// Figures for LaTeX: the texts, the structure of the file, and that LaTeX typesets every view of the list.
#include <algorithm>
#include <cctype>

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QTemporaryDir>

#include "foreign_tracer.h"
#include "painting/tex_text.h"
#include "painting/tikz.h"
#include "panes/figure.h"
#include "panes/figure_formats.h"
#include "window_fixture.h"
#include "windows/pane_list.h"
#include "workspace/snapshot_maker.h"

namespace reliefui {

namespace {

QString contents(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

TEST(TexText, signsBecomeCommands) {
    const std::vector<std::pair<std::string, std::string>> all{
        {"50 % & #1_a {b}", "50 \\% \\& \\#1\\_a \\{b\\}"},
        {"a\\b~c^d$", "a\\textbackslash{}b\\textasciitilde{}c\\textasciicircum{}d\\$"},
        {"λ = −0.5", "\\ensuremath{\\lambda} = \\ensuremath{-}0.5"},
        {"10⁻³", "10\\ensuremath{^{-}}\\ensuremath{^{3}}"},
        {"--tracers", "-{}-tracers"},
        {"крок 2 з «5»", "крок 2 з «5»"}};
    for (const auto& [text, tex] : all) EXPECT_EQ(texText(text), tex);
}

TEST(TexText, formulasAreMathematics) {
    EXPECT_EQ(texFormula("V_{i+1} = 2 V_i^2"), "$V_{i+1}\\ =\\ 2\\ V_{i}^{2}$");
    EXPECT_EQ(texFormula("λ ≤ max(a, 1)"), "$\\lambda \\ \\le \\ \\mathrm{max}(a,\\ 1)$");
    EXPECT_EQ(texFormula("10⁻³"), "$10{}^{-}{}^{3}$") << "two superscripts of one base are an error";
    EXPECT_EQ(texFormula("мінус #"), "$\\mbox{мінус}\\ \\mbox{\\#}$");
}

// Every sign of the catalogue is either known to LaTeX or a letter, a quotation mark or a number sign of Ukrainian.
TEST(TexText, everyMessageIsKnown) {
    const QString catalogue = contents(QStringLiteral(RELIEF_SOURCE "/algorithms/include/relief/messages.def"));
    ASSERT_GT(catalogue.size(), 10000);
    const QString tex = QString::fromStdString(texText(catalogue.toStdString()));
    const QRegularExpression other(QStringLiteral("[^\\x{0}-\\x{7F}\\x{400}-\\x{4FF}«»№›]"));
    EXPECT_FALSE(other.match(tex).hasMatch()) << other.match(tex).captured().toStdString();
}

// Braces pair up, every colour is defined, and no coordinate or number is written with a decimal comma.
void expectWellFormed(const QString& tikz, double widthMm) {
    int depth = 0;
    for (int k = 0; k < tikz.size() && depth >= 0; ++k) {
        const bool escaped = k > 0 && tikz[k - 1] == QLatin1Char('\\');
        if (!escaped && tikz[k] == QLatin1Char('{')) ++depth;
        if (!escaped && tikz[k] == QLatin1Char('}')) --depth;
    }
    EXPECT_EQ(depth, 0);
    for (const char* const part : {"tikzpicture", "scope"}) {
        const QString name = QStringLiteral("{") + QLatin1String(part) + QStringLiteral("}");
        EXPECT_EQ(tikz.count(QStringLiteral("\\begin") + name), tikz.count(QStringLiteral("\\end") + name)) << part;
    }
    const auto box =
        QRegularExpression(QStringLiteral("useasboundingbox \\(0,0\\) rectangle \\(([0-9.]+),([0-9.]+)\\)"))
            .match(tikz);
    ASSERT_TRUE(box.hasMatch());
    EXPECT_NEAR(box.captured(1).toDouble(), widthMm / kMmPerPoint, 0.1);
    EXPECT_GT(box.captured(2).toDouble(), 20);
    EXPECT_FALSE(tikz.contains(QStringLiteral("nan"))) << "a coordinate is no number";
    auto names = QRegularExpression(QStringLiteral("[\\[=]rs([A-Z][A-Za-z0-9]*)")).globalMatch(tikz);
    EXPECT_TRUE(names.hasNext());
    while (names.hasNext()) {
        const QString name = names.next().captured(1);
        EXPECT_TRUE(tikz.contains(QStringLiteral("\\providecolor{rs") + name + QStringLiteral("}")))
            << name.toStdString();
    }
}

bool runs(const char* program, const QString& argument) {
    return QProcess::execute(QLatin1String(program), {argument}) == 0;
}

// Runs LaTeX on a document that includes these figures, without making a PDF. Returns what it complained about; empty:
// nothing. cyrillic: the fonts of the words.
QString typeset(const QString& folder, const QStringList& figures, bool cyrillic) {
    QFile document(QDir(folder).filePath(QStringLiteral("all.tex")));
    if (!document.open(QIODevice::WriteOnly)) return QStringLiteral("no file");
    QString text = QStringLiteral("\\documentclass{article}\n");
    if (cyrillic) text += QStringLiteral("\\usepackage[T2A]{fontenc}\n");
    text += QStringLiteral("\\usepackage{tikz}\n\\begin{document}\n");
    for (const QString& figure : figures) text += QStringLiteral("\\input{%1}\\clearpage\n").arg(figure);
    document.write((text + QStringLiteral("\\end{document}\n")).toUtf8());
    document.close();
    QProcess latex;
    latex.setWorkingDirectory(folder);
    latex.start(QStringLiteral("pdflatex"),
                {QStringLiteral("-interaction=nonstopmode"), QStringLiteral("-halt-on-error"),
                 QStringLiteral("-draftmode"), QStringLiteral("all.tex")});
    constexpr int kPatienceMs = 300000;
    if (!latex.waitForFinished(kPatienceMs)) return QStringLiteral("not finished");
    constexpr int kTail = 1500;
    const QString log = QString::fromUtf8(latex.readAllStandardOutput());
    return latex.exitCode() == 0 ? QString() : log.right(kTail);
}

// Every view of the list, in the width of a column, with a picture file if it holds pixels; typeset if LaTeX is there.
TEST(Tikz, everyViewIsForLatex) {
    relief::Scenario scenario = smallScenario();
    scenario.method = {"layers", {{"layers", "8"}}};
    scenario.comparison.others = {{"max-pyramid", {}}};
    scenario.step = 1;
    relief::Work work;
    SnapshotMaker maker;
    const auto snapshot = maker.make({scenario}, work);
    const QTemporaryDir folder;
    const relief::Scenario foreign = withForeignTracer(scenario, folder, true);
    const auto diagnosed = maker.make({foreign}, work);
    QStringList written;
    for (const FigureKind& kind : figureList()) {
        // "charts" measures for seconds; "drawn" needs a relief drawn by hand.
        if (!kind.make || !kind.vectors || kind.name == "charts" || kind.name == "drawn") continue;
        SCOPED_TRACE(kind.name);
        FigurePage page;
        page.title = kind.name;
        page.widthMm = kColumnMm;
        page.dpi = 100;
        page.style.theme = Theme::Light;
        const QString name = QString::fromStdString(kind.name) + QStringLiteral(".tikz");
        const bool doctor = kind.name == "doctor";  // shows the files of another tracer
        writeFigure(*kind.make(doctor ? diagnosed : snapshot, doctor ? foreign : scenario), page,
                    folder.filePath(name).toStdString(), work);
        const QString tikz = contents(folder.filePath(name));
        expectWellFormed(tikz, kColumnMm);
        EXPECT_LT(tikz.size(), 3000000);
        EXPECT_GT(tikz.count(QStringLiteral("\\node")), 0);
        const int pictures = tikz.count(QStringLiteral("\\includegraphics"));
        EXPECT_EQ(pictures > 0, QFile::exists(folder.filePath(QString::fromStdString(kind.name) + "-1.png")));
        if (kind.name == "result") {
            EXPECT_EQ(pictures, 1);
        }
        if (kind.name != "trace") written << name;  // thousands of cells; LaTeX gets a smaller one below
    }
    EXPECT_GE(written.size(), 10);
    const auto writeAs = [&](const char* view, const relief::Scenario& shown, relief::Language language,
                             const QString& name) {
        FigurePage page;
        page.style.language = language;
        const auto drawn = maker.make({shown}, work);
        writeFigure(*figureKind(view).make(drawn, shown), page, folder.filePath(name).toStdString(), work);
        expectWellFormed(contents(folder.filePath(name)), page.widthMm);
    };
    relief::Scenario small = scenario;
    small.surface = relief::Surface::Columns;
    small.pictures.recipeWidth = small.pictures.recipeHeight = 16;
    writeAs("trace", small, relief::Language::English, QStringLiteral("small.tikz"));
    written << QStringLiteral("small.tikz");
    const QString ukrainian = QStringLiteral("ukrainian.tex");
    writeAs("steps", scenario, relief::Language::Ukrainian, ukrainian);
    if (QStandardPaths::findExecutable(QStringLiteral("pdflatex")).isEmpty() ||
        !runs("kpsewhich", QStringLiteral("tikz.sty"))) {
        GTEST_SKIP() << "LaTeX with TikZ is not installed, so that the figures are not typeset";
    }
    EXPECT_EQ(typeset(folder.path(), written, false).toStdString(), "");
    if (!runs("kpsewhich", QStringLiteral("larm1000.tfm"))) return;
    EXPECT_EQ(typeset(folder.path(), {ukrainian}, true).toStdString(), "");
}

// A clip becomes a scope, transforms and alpha values are kept, and names of files are usable by TeX.
TEST(Tikz, thePainterStateIsKept) {
    const QTemporaryDir folder;
    const auto figure = paintedFigure(
        [](QPainter& painter, const Box& page, const Style&) {
            painter.save();
            painter.setClipRect(QRectF(0, 0, page.width() / 2, page.height()), Qt::IntersectClip);
            painter.setPen(QPen(QColor(213, 94, 0, 128), 8, Qt::DashLine));
            painter.drawLine(QLineF(0, 0, page.width(), page.height()));
            painter.restore();
            painter.translate(80, 160);
            painter.setPen(Qt::NoPen);
            painter.setBrush(QColor(0, 0, 0));
            painter.drawEllipse(QPointF(0, 0), 16, 16);
            painter.drawImage(QRectF(0, 0, 40, 40), QImage(4, 4, QImage::Format_RGB32));
        },
        {});
    relief::Work work;
    const QString path = folder.filePath(QStringLiteral("a picture.tex"));
    writeFigure(*figure, {}, path.toStdString(), work);
    const QString tikz = contents(path);
    expectWellFormed(tikz, FigurePage().widthMm);
    const int scope = tikz.indexOf(QStringLiteral("\\begin{scope}\\clip"));
    const int line = tikz.indexOf(QStringLiteral("\\draw[rsVermilion,line width=1bp,draw opacity=0.5"));
    const int end = tikz.lastIndexOf(QStringLiteral("\\end{scope}"));
    EXPECT_TRUE(0 < scope && scope < line && line < end) << tikz.toStdString();
    EXPECT_TRUE(tikz.contains(QStringLiteral("dash pattern=on ")));
    EXPECT_TRUE(tikz.contains(QStringLiteral("\\fill[rsBlack] (10,20) circle[radius=2]"))) << tikz.toStdString();
    EXPECT_TRUE(QFile::exists(folder.filePath(QStringLiteral("a-picture-1.png"))));
    EXPECT_EQ(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden).size(), 2);
}

// Smallest height, in points, of the letters of a figure.
double smallestText(const QString& tikz) {
    auto sizes = QRegularExpression(QStringLiteral("reliefscopefont\\{([0-9.]+)\\}")).globalMatch(tikz);
    double least = 1e9;
    while (sizes.hasNext()) least = std::min(least, sizes.next().captured(1).toDouble());
    return least;
}

// In the widths of journals all letters have at least 5.5 points: titles of axes and digits where there is no room for
// more; most have 7 to 10.
TEST(Tikz, textIsLegibleInJournals) {
    relief::Scenario scenario = smallScenario();
    scenario.comparison.others = {{"layers", {}}};
    scenario.step = 1;
    relief::Work work;
    SnapshotMaker maker;
    const auto snapshot = maker.make({scenario}, work);
    const QTemporaryDir folder;
    const relief::Scenario foreign = withForeignTracer(scenario, folder, true);
    const auto diagnosed = maker.make({foreign}, work);
    for (const FigureKind& kind : figureList()) {
        if (!kind.make || !kind.vectors || kind.name == "charts" || kind.name == "drawn") continue;
        for (const double width : {kColumnMm, kJournalPageMm}) {
            FigurePage page;
            page.widthMm = width;
            page.dpi = 100;
            const QString path = folder.filePath(QStringLiteral("figure.tikz"));
            const bool doctor = kind.name == "doctor";
            writeFigure(*kind.make(doctor ? diagnosed : snapshot, doctor ? foreign : scenario), page,
                        path.toStdString(), work);
            const double least = smallestText(contents(path));
            EXPECT_GE(least, 5.5) << kind.name << " " << width;
        }
    }
}

}  // namespace

}  // namespace reliefui
