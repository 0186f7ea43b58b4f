// The figures of the papers: the set is complete, each is written again byte for byte from its own file, and the
// numbers in captions are those of the pictures.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>

#include <gtest/gtest.h>
#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QProcess>
#include <QTemporaryDir>

#include "measuring/compare/picture_error.h"
#include "panes/pdf_date.h"
#include "relief/files.h"
#include "windows/paper_figures.h"
#include "workspace/snapshot_maker.h"

namespace reliefui {

namespace {

constexpr int kPatienceMs = 120000;
const std::string kFolder = RELIEF_SOURCE "/ui/paper_figures";

struct Ended {
    int status = -1;
    QString out, complaint;
};

// Runs the program without a display in a folder, with these variables.
Ended run(const QStringList& arguments, const QString& folder, const std::map<QString, QString>& variables = {}) {
    QProcess process;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    for (const char* const name : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM", "SOURCE_DATE_EPOCH"}) {
        environment.remove(QLatin1String(name));
    }
    environment.insert(QStringLiteral("LC_ALL"), QStringLiteral("C.UTF-8"));
    environment.insert(QStringLiteral("LIBGL_ALWAYS_SOFTWARE"), QStringLiteral("1"));
    environment.insert(QStringLiteral("ASAN_OPTIONS"), QStringLiteral("detect_leaks=0"));
    for (const auto& [name, value] : variables) environment.insert(name, value);
    process.setProcessEnvironment(environment);
    process.setWorkingDirectory(folder);
    process.start(QStringLiteral(RELIEFSCOPE), arguments);
    if (!process.waitForFinished(kPatienceMs)) return {};
    return {process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -1,
            QString::fromUtf8(process.readAllStandardOutput()), QString::fromUtf8(process.readAllStandardError())};
}

Ended write(const QString& names, const QString& folder, const QString& from,
            const std::map<QString, QString>& variables = {}) {
    const Ended done = run({QStringLiteral("--paper-figures"), names, QStringLiteral("-o"), folder}, from, variables);
    EXPECT_EQ(done.complaint.toStdString(), "");
    EXPECT_EQ(done.status, 0);
    return done;
}

QByteArray contents(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

QStringList filesIn(const QString& folder) {
    return QDir(folder).entryList(QDir::Files, QDir::Name);
}

// The file's table of objects points at them.
void expectObjectsInPlace(const QByteArray& pdf) {
    const int table = pdf.mid(pdf.lastIndexOf("startxref\n") + 10).split(' ').front().toInt();
    ASSERT_EQ(pdf.mid(table, 5), "xref\n");
    const QList<QByteArray> lines = pdf.mid(table).split('\n');
    int number = 0, found = 0;
    for (int i = 2; i < lines.size() && lines[i].size() == 19; ++i, ++number) {
        if (!lines[i].endsWith("n ")) continue;
        const QByteArray object = QByteArray::number(number) + " 0 obj\n";
        EXPECT_EQ(pdf.mid(lines[i].left(10).toInt(), object.size()), object) << number;
        ++found;
    }
    EXPECT_GT(found, 5);
}

TEST(PaperFigures, AllFiguresOfThePapersAreThere) {
    const Ended all = run({QStringLiteral("--paper-figures"), QStringLiteral("all")}, QDir::tempPath(),
                          {{QStringLiteral("LC_ALL"), QStringLiteral("uk_UA.UTF-8")}});
    EXPECT_EQ(all.status, 0) << all.complaint.toStdString();
    const QStringList lines = all.out.split(QLatin1Char('\n'), Qt::SkipEmptyParts);
    int line = 0;
    for (const auto& [paper, figures] : {std::pair("DIST17", 8), {"MIP18", 6}, {"PERSP", 4}, {"TEX", 5}}) {
        for (int n = 1; n <= figures; ++n, ++line) {
            ASSERT_LT(line, lines.size());
            const QString begin = QStringLiteral("%1-%2  [%1], рис. %2").arg(QLatin1String(paper)).arg(n);
            EXPECT_TRUE(lines[line].startsWith(begin)) << lines[line].toStdString();
        }
    }
    EXPECT_EQ(line, lines.size());
}

// Another time zone, language and folder, and the figure's own file instead of its name. With RELIEF_LONG: all figures,
// by name.
TEST(PaperFigures, AreWrittenAgainByteForByte) {
    const QTemporaryDir folder;
    const std::map<QString, QString> date{{QStringLiteral("SOURCE_DATE_EPOCH"), QStringLiteral("1764201600")}};
    const QString first = folder.filePath(QStringLiteral("first")), second = folder.filePath(QStringLiteral("second"));
    const bool all = std::getenv("RELIEF_LONG") != nullptr;
    write(all ? QStringLiteral("all") : QStringLiteral("DIST17-5,PERSP-4,MIP18-4"), first, folder.path(), date);
    std::map<QString, QString> elsewhere = date;
    elsewhere[QStringLiteral("TZ")] = QStringLiteral("Asia/Tokyo");
    elsewhere[QStringLiteral("LC_ALL")] = QStringLiteral("uk_UA.UTF-8");
    write(all ? QStringLiteral("all") : QStringLiteral("DIST17-5.json,PERSP-4.json,MIP18-4.json"), second, first,
          elsewhere);
    const QStringList names = filesIn(first);
    EXPECT_EQ(names, filesIn(second));
    // Pictures in three formats and captions, in two languages; three files that say how; two documents.
    const int three = (2 + 1 + 3) * 6 + 3 * 2 + 3 + 2;
    if (all) {
        EXPECT_GT(names.size(), 4 * three);
    } else {
        EXPECT_EQ(names.size(), three);
    }
    for (const QString& name : names) {
        // 3-D pictures are drawn by OpenGL.
        if (name.startsWith(QLatin1String("MIP18-4-c")) || name == QLatin1String("MIP18-4.json")) continue;
        EXPECT_TRUE(contents(first + '/' + name) == contents(second + '/' + name)) << name.toStdString();
    }
    relief::Work work(1);
    const auto picture = [&](const QString& where) {
        return relief::readColor((where + QStringLiteral("/MIP18-4-c-uk.png")).toStdString(), work);
    };
    relief::FloatImage map;
    constexpr double kBound = 0.001;
    EXPECT_LT(relief::pictureError(picture(first), picture(second), relief::kPixelsPerDegree, map, work).flip, kBound);
}

TEST(PaperFigures, SayHowTheyWereMade) {
    const QTemporaryDir folder;
    write(QStringLiteral("MIP18-3"), folder.path(), folder.path());
    const std::string text = relief::readTextFile(folder.filePath(QStringLiteral("MIP18-3.json")).toStdString());
    const nlohmann::json json = nlohmann::json::parse(text);
    EXPECT_EQ(json.dump(2) + "\n", text) << "sorted";
    EXPECT_EQ(json["command"], "reliefscope --paper-figures MIP18-3.json -o .");
    EXPECT_EQ(json["files"].size(), 8u);
    for (const auto& [name, sum] : json["files"].items()) {
        const QByteArray bytes = contents(folder.filePath(QString::fromStdString(name)));
        EXPECT_EQ(QCryptographicHash::hash(bytes, QCryptographicHash::Sha256).toHex().toStdString(), sum) << name;
    }
    const QString tex = QString::fromUtf8(contents(folder.filePath(QStringLiteral("MIP18-3-uk.tex"))));
    for (const char* const part :
         {"% [MIP18], рис. 3: Приклад MIP-піраміди максимальних значень\n",
          "% reliefscope --paper-figures MIP18-3.json -o .\n", "\\includegraphics[width=84mm]{MIP18-3-uk}\n",
          "\\caption{Приклад зі статті", "За [MIP18], рис. 3.}\n", "\\label{fig:MIP18-3}\n\\end{figure}\n"}) {
        EXPECT_TRUE(tex.contains(QString::fromUtf8(part))) << part << tex.toStdString();
    }
    EXPECT_TRUE(contents(folder.filePath(QStringLiteral("all-uk.tex"))).contains("\\input{MIP18-3-uk}"));
    EXPECT_TRUE(contents(folder.filePath(QStringLiteral("MIP18-3-uk.svg"))).contains("рівень"));
    EXPECT_TRUE(contents(folder.filePath(QStringLiteral("MIP18-3-en.svg"))).contains("level"));
}

// A PDF has the date of SOURCE_DATE_EPOCH or none, and remains a PDF.
TEST(PaperFigures, PdfsHaveTheSourcesDate) {
    const QTemporaryDir folder;
    const auto pdf = [&](const std::map<QString, QString>& variables) {
        write(QStringLiteral("PERSP-2"), folder.path(), folder.path(), variables);
        return contents(folder.filePath(QStringLiteral("PERSP-2-en.pdf")));
    };
    const QByteArray dated = pdf({{QStringLiteral("SOURCE_DATE_EPOCH"), QStringLiteral("1764201600")}});
    EXPECT_TRUE(dated.contains("\n/CreationDate (D:20251127000000Z)\n"));
    EXPECT_TRUE(contents(folder.filePath(QStringLiteral("PERSP-2-uk.tex")))
                    .contains("% SOURCE_DATE_EPOCH=1764201600 reliefscope --paper-figures PERSP-2.json -o .\n"));
    const QByteArray plain = pdf({});
    EXPECT_FALSE(plain.contains("Date"));
    for (const QByteArray& one : {dated, plain}) expectObjectsInPlace(one);
    EXPECT_EQ(withSourceDate("no pdf"), "no pdf");
}

TEST(PaperFigures, FaultsAreNamedInOneLine) {
    const QTemporaryDir folder;
    const std::string good = relief::readTextFile(kFolder + "/MIP18-4.json");
    const auto refused = [&](const char* pointer, const nlohmann::json& value, const char* what) {
        nlohmann::json changed = nlohmann::json::parse(good);
        changed[nlohmann::json::json_pointer(pointer)] = value;
        const std::string file = folder.filePath(QStringLiteral("mine.json")).toStdString();
        relief::writeTextFile(file, changed.dump(1));
        try {
            readPaperFigure(file, RELIEF_DATASETS);
            ADD_FAILURE() << pointer << " is taken";
        } catch (const relief::InputError& error) {
            const std::string text = error.text(relief::Language::English);
            EXPECT_NE(text.find("mine.json: line "), std::string::npos) << text;
            EXPECT_NE(text.find(what), std::string::npos) << text;
        }
    };
    refused("/paper-figure", 2, "version 1");
    refused("/number", 0, "number");
    refused("/page", -1, "page");
    refused("/extra", 1, "extra");
    refused("/caption/uk", "", "uk");
    refused("/parts", nlohmann::json::array(), "parts");
    refused("/parts/1/view", "profle", "profile");
    refused("/parts/1/view", "pareto", "view");
    refused("/parts/1/layer", "colour", "color");
    refused("/parts/1/width", 5, "20 to 2000");
    refused("/parts/1/change", 1, "change");
    refused("/scenario/method/name", "max", "max-pyramid");
    refused("/scenario/ui", nlohmann::json{{"profile", {{"nearray", true}}}}, "nearray");

    const auto complaint = [&](const QStringList& arguments, const std::map<QString, QString>& variables = {}) {
        const Ended done = run(QStringList{QStringLiteral("--paper-figures")} + arguments, folder.path(), variables);
        EXPECT_EQ(done.status, 2);
        EXPECT_EQ(done.complaint.count('\n'), 1) << done.complaint.toStdString();
        return done.complaint.toStdString();
    };
    EXPECT_NE(complaint({QStringLiteral("MIP18-7")}).find("MIP18-6"), std::string::npos);
    EXPECT_NE(complaint({QStringLiteral("none.json")}).find("none.json"), std::string::npos);
    EXPECT_NE(complaint({QStringLiteral("all"), QStringLiteral("--lesson"), QStringLiteral("302")}).find("--lesson"),
              std::string::npos);
    EXPECT_NE(complaint({QStringLiteral("PERSP-1"), QStringLiteral("-o"), folder.path()},
                        {{QStringLiteral("SOURCE_DATE_EPOCH"), QStringLiteral("today")}})
                  .find("SOURCE_DATE_EPOCH"),
              std::string::npos);
}

// Of a list of names: the figures of each, in the order of their numbers; where there are none, it is said.
TEST(PaperFigures, NamesSelectFiguresInTheirOrder) {
    const auto named = [](const std::string& names) {
        QStringList stems;
        for (const std::string& file : paperFigureFiles(names, kFolder)) {
            stems << QFileInfo(QString::fromStdString(file)).completeBaseName();
        }
        return stems.join(',').toStdString();
    };
    EXPECT_EQ(named("PERSP"), "PERSP-1,PERSP-2,PERSP-3,PERSP-4");
    EXPECT_EQ(named("MIP18-4,mine.json,PERSP-2"), "MIP18-4,mine,PERSP-2");
    const QTemporaryDir empty;
    try {
        paperFigureFiles("all", empty.path().toStdString());
        ADD_FAILURE() << "nothing is enough";
    } catch (const relief::InputError& error) {
        EXPECT_EQ(error.message().id, relief::MessageId::PaperFiguresNotFound);
    }
}

// A caption's formulas are TeX's; a single dollar is a sign.
TEST(PaperFigures, CaptionsAreTex) {
    const QTemporaryDir folder;
    PaperFigure figure;
    figure.name = "mine";
    figure.json = relief::Json::object();
    figure.caption = {"$u_t$ of 50% & a_b", "5 $ or 5_6"};
    relief::Work work;
    writePaperFigure(
        figure, folder.path().toStdString(), "1", [](relief::Language) {}, work);
    EXPECT_TRUE(contents(folder.filePath(QStringLiteral("mine-en.tex"))).contains("{$u_t$ of 50\\% \\& a\\_b "));
    EXPECT_TRUE(contents(folder.filePath(QStringLiteral("mine-uk.tex"))).contains("{5 \\$ or 5\\_6 "));
}

// The trace of each part's ray.
std::vector<std::shared_ptr<const Snapshot>> shown(const char* name) {
    const PaperFigure figure = readPaperFigure(kFolder + "/" + name + ".json", RELIEF_DATASETS);
    std::vector<std::shared_ptr<const Snapshot>> parts;
    for (const PaperFigure::Part& part : figure.parts) {
        SnapshotOrder order;
        order.scenario = part.scenario;
        relief::Work work;
        parts.push_back(SnapshotMaker().make(order, work));
    }
    return parts;
}

TEST(PaperFigures, CaptionsSayWhatThePicturesShow) {
    // Figures 6 and 8: one step less, the same hits.
    const auto plain = shown("DIST17-6"), refined = shown("DIST17-8");
    ASSERT_EQ(plain.size(), 2u);
    for (std::size_t n = 0; n < 2; ++n) {
        EXPECT_EQ(plain[n]->trace.steps.size(), refined[n]->trace.steps.size() + 1);
        EXPECT_NEAR(plain[n]->trace.hit.lambda, 0.8, 1e-3);
        EXPECT_NEAR(refined[n]->trace.hit.lambda, 0.8, 1e-3);
        // Through C: 4 texels from the side, at the height 0.6.
        const relief::ViewRay& ray = plain[n]->trace.ray;
        EXPECT_NEAR(ray.s0 + 0.4 * ray.a, 4, 1e-3);
    }
    // Figure 5: both hit before C, half the slab deep in the middle.
    for (const auto& part : shown("DIST17-5")) {
        EXPECT_NEAR(part->trace.ray.s0 + 0.5 * part->trace.ray.a, 9, 0.01);
        EXPECT_LT(part->trace.hit.lambda, 0.25);
        EXPECT_EQ(part->trace.hit.outcome, relief::Outcome::Hit);
    }
    // Step 6 goes down to a maximum of 0.8, step 7 skips at level 0, step 8 goes up again.
    const auto vain = shown("MIP18-5").front();
    const std::vector<relief::Step>& steps = vain->trace.steps;
    ASSERT_GT(steps.size(), 8u);
    EXPECT_EQ(vain->scenario.step, 7);
    EXPECT_EQ(steps[5].decision, relief::Decision::Descend);
    EXPECT_NEAR(steps[5].value, 0.8, 1e-6);
    EXPECT_EQ(steps[6].decision, relief::Decision::Skip);
    EXPECT_EQ(steps[6].level, 0);
    EXPECT_EQ(steps[7].decision, relief::Decision::Ascend);
    // The offset ends far from the exact hit, the last layer near it.
    const auto offset = shown("DIST17-1").front(), layers = shown("DIST17-2").front();
    EXPECT_GT(offset->trace.hit.lambda - offset->trace.exact.lambda, 0.2);
    EXPECT_LT(std::abs(layers->trace.hit.lambda - layers->trace.exact.lambda), 1 / 8.0);
}

}  // namespace

}  // namespace reliefui
