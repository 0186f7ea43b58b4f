// The program `reliefscope` at start: its arguments, and a missing display.
#include <array>
#include <cmath>
#include <fstream>

#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QTemporaryFile>
#include <QTranslator>
#include <QXmlStreamReader>

#include "window_fixture.h"
#include "windows/display_check.h"
#include "windows/pane_list.h"

namespace reliefui {

namespace {

struct Ran {
    int status = -1;
    QString out;
    QString err;
};

Ran start(const QStringList& arguments, bool display = true, const QString& locale = QStringLiteral("C.UTF-8"),
          const QString& scale = QStringLiteral("1")) {
    QProcess process;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("LC_ALL"), locale);
    environment.insert(QStringLiteral("QT_SCALE_FACTOR"), scale);
    // Leaks of the window are checked in this process; in the program they could not be distinguished from those of
    // unloaded drivers.
    environment.insert(QStringLiteral("ASAN_OPTIONS"), QStringLiteral("detect_leaks=0"));
    if (!display) environment.remove(QStringLiteral("DISPLAY"));
    process.setProcessEnvironment(environment);
    process.start(QStringLiteral(RELIEFSCOPE), arguments);
    process.waitForFinished(60000);
    Ran ran;
    ran.status = process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -1;
    ran.out = QString::fromUtf8(process.readAllStandardOutput());
    ran.err = QString::fromUtf8(process.readAllStandardError());
    return ran;
}

bool oneLine(const QString& text) {
    return text.endsWith('\n') && text.count('\n') == 1;
}

// These tests need no display.
TEST(Program, WithoutADisplayItSaysSo) {
    for (const QStringList& arguments : {QStringList{}, QStringList{QStringLiteral("--check-display")}}) {
        const Ran ran = start(arguments, false);
        EXPECT_EQ(ran.status, 2);
        EXPECT_TRUE(oneLine(ran.err)) << ran.err.toStdString();
        EXPECT_TRUE(ran.err.startsWith(QStringLiteral("reliefscope: "))) << ran.err.toStdString();
    }
}

TEST(Program, HelpAndVersion) {
    const Ran help = start({QStringLiteral("--help")}, false);
    EXPECT_EQ(help.status, 0);
    EXPECT_TRUE(help.out.contains(QStringLiteral("Usage: reliefscope")));
    for (const FigureKind& kind : figureList()) {
        EXPECT_TRUE(help.out.contains(QString::fromStdString(' ' + kind.name))) << kind.name;
    }
    EXPECT_TRUE(start({QStringLiteral("--version")}, false).out.startsWith(QStringLiteral("reliefscope ")));
}

TEST(Program, LessonsAreCheckedWithoutADisplay) {
    const auto run = [](const char* text) { return start(QString::fromUtf8(text).split(QLatin1Char(' ')), false); };
    const Ran good = run("--lesson 301 --check");
    EXPECT_EQ(good.status, 0) << good.err.toStdString();
    EXPECT_TRUE(good.out.startsWith(QStringLiteral("301 holds: "))) << good.out.toStdString();
    // A folder of two lessons, one whose claim is wrong, one that cannot be read.
    const QTemporaryDir folder;
    const auto copied = [&](const char* name, const QByteArray& from, const QByteArray& to) {
        const QDir source(QStringLiteral(RELIEF_SOURCE "/ui/lessons/301"));
        QDir(folder.path()).mkdir(QLatin1String(name));
        for (const QString& file : source.entryList(QDir::Files)) {
            QFile read(source.filePath(file)), write(folder.filePath(QLatin1String(name) + QLatin1Char('/') + file));
            EXPECT_TRUE(read.open(QIODevice::ReadOnly) && write.open(QIODevice::WriteOnly));
            write.write(file.endsWith(QStringLiteral(".json")) ? read.readAll().replace(from, to) : read.readAll());
        }
    };
    copied("wrong", "\"trace.error > 1\"", "\"trace.error > 1000\"");
    Ran ran = start({QStringLiteral("--lesson"), folder.path(), QStringLiteral("--check")}, false);
    EXPECT_EQ(ran.status, 1);
    EXPECT_TRUE(ran.out.contains(QStringLiteral("trace.error > 1000 ("))) << ran.out.toStdString();
    copied("unread", "\"lesson\": 1", "\"lesson\": 7");
    ran = start({QStringLiteral("--lesson"), folder.path(), QStringLiteral("--check")}, false);
    EXPECT_EQ(ran.status, 2);
    EXPECT_TRUE(ran.out.contains(QStringLiteral("wrong FAILS"))) << ran.out.toStdString();
    for (const char* const text :
         {"--lesson 3o1 --check", "--check", "--html -o x.html", "--lesson 301 --html", "--lesson 301 --html -o x.txt",
          "--lesson 301 --check --html -o x.html", "--lesson 301 --export profile -o x.svg", "--lesson 301 a.png",
          "--sequence steps", "--export profile --sequence step -o x.png", "--export profile --frames 3 -o x.png",
          "--export profile --sequence steps --frames 3 -o x.png", "--export skipped --sequence steps -o x.png",
          "--export result --sequence orbit --frames 0 -o x.png",
          "--export result --sequence sweep:nothing=1..2 -o x.png"}) {
        const Ran bad = run(text);
        EXPECT_EQ(bad.status, 2) << text;
        EXPECT_TRUE(oneLine(bad.err)) << text << ": " << bad.err.toStdString();
    }
    EXPECT_TRUE(run("--lesson 3o1 --check").err.contains(QStringLiteral("301"))) << "the name that was meant";
}

TEST(Program, BadUsage) {
    const QList<QStringList> cases{{QStringLiteral("--nonsense")},
                                   {QStringLiteral("a.png"), QStringLiteral("b.png")},
                                   {QStringLiteral("--"), QStringLiteral("--help"), QStringLiteral("--version")},
                                   {QStringLiteral("--screenshot")},
                                   {QStringLiteral("--screenshot"), QString()},
                                   {QStringLiteral("--size"), QStringLiteral("12")}};
    for (const QStringList& arguments : cases) {
        const Ran ran = start(arguments, false);
        EXPECT_EQ(ran.status, 2) << arguments.join(' ').toStdString();
        EXPECT_TRUE(oneLine(ran.err)) << ran.err.toStdString();
    }
    const QStringList figure{QStringLiteral("-o"), QStringLiteral("x.svg")};
    for (const auto& [option, near] : {std::pair("--expot", "--export"), std::pair("--export=", "--export"),
                                       std::pair("--pixle", "--pixel"), std::pair("--nonsense", "")}) {
        const Ran ran = start(QStringList{QString::fromLatin1(option), QStringLiteral("profile")} + figure, false);
        EXPECT_EQ(ran.status, 2) << option;
        const bool proposed = ran.err.contains(QStringLiteral("did you mean ") + QString::fromLatin1(near));
        EXPECT_EQ(proposed, *near != '\0') << ran.err.toStdString();
    }
    const Ran view = start(QStringList{QStringLiteral("--export"), QStringLiteral("profle")} + figure, false);
    EXPECT_TRUE(view.err.contains(QStringLiteral("did you mean \"profile\"?"))) << view.err.toStdString();
}

TEST_F(WindowTest, BadInputIsReportedBeforeAWindowOpens) {
    const QTemporaryDir folder;
    const QString broken = folder.filePath(QString::fromUtf8("не картинка.png"));
    std::ofstream(broken.toStdString()) << "no";
    for (const QString& path : {broken, folder.filePath(QStringLiteral("missing.json")), folder.path()}) {
        const Ran ran = start({path});
        EXPECT_EQ(ran.status, 2);
        EXPECT_TRUE(oneLine(ran.err)) << ran.err.toStdString();
        EXPECT_TRUE(ran.err.startsWith(QStringLiteral("reliefscope: ") + path + QStringLiteral(": ")))
            << ran.err.toStdString();
    }
}

TEST_F(WindowTest, UkrainianTextsAreThere) {
    QTranslator translator;
    ASSERT_TRUE(translator.load(QStringLiteral(":/translations/reliefscope_uk.qm")));
    EXPECT_EQ(translator.translate("reliefui::ResultView", "Result"), QString::fromUtf8("Результат"));
    // Numbers are formatted as in the C locale.
    EXPECT_EQ(start({QStringLiteral("--version")}, true, QStringLiteral("uk_UA.UTF-8")).status, 0);
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("window.png"));
    const Ran ran = start({QStringLiteral("--screenshot"), file}, true, QStringLiteral("uk_UA.UTF-8"));
    EXPECT_EQ(ran.status, 0);
    EXPECT_EQ(ran.err.toStdString(), "");
    EXPECT_FALSE(QImage(file).isNull());
}

// Every text that lupdate finds in the sources has a translation, and none is marked unfinished.
TEST(Translations, everyTextOfTheWindowHasOne) {
    const QTemporaryDir folder;
    const QString copy = folder.filePath(QStringLiteral("reliefscope_uk.ts"));
    const QString source = QStringLiteral(RELIEF_SOURCE);
    ASSERT_TRUE(QFile::copy(source + QStringLiteral("/ui/reliefscope_uk.ts"), copy));
    QFile::setPermissions(copy, QFile::ReadOwner | QFile::WriteOwner);
    QProcess lupdate;
    lupdate.start(
        QStringLiteral(RELIEF_LUPDATE),
        {QStringLiteral("-locations"), QStringLiteral("none"), QStringLiteral("-no-obsolete"),
         source + QStringLiteral("/ui"), source + QStringLiteral("/app/reliefscope"), QStringLiteral("-ts"), copy});
    ASSERT_TRUE(lupdate.waitForFinished(60000));
    ASSERT_EQ(lupdate.exitCode(), 0);
    QFile file(copy);
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    QXmlStreamReader xml(&file);
    QString text;
    int translated = 0;
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement) continue;
        if (xml.name() == QLatin1String("source")) text = xml.readElementText();
        if (xml.name() != QLatin1String("translation")) continue;
        EXPECT_NE(xml.attributes().value(QLatin1String("type")), QLatin1String("unfinished")) << text.toStdString();
        ++translated;
        EXPECT_FALSE(xml.readElementText(QXmlStreamReader::IncludeChildElements).isEmpty()) << text.toStdString();
    }
    EXPECT_FALSE(xml.hasError()) << xml.errorString().toStdString();
    EXPECT_GT(translated, 300);
}

TEST_F(WindowTest, TheScreenshotShowsTheWindowWithoutAWordOfComplaint) {
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("window.png"));
    QElapsedTimer clock;
    clock.start();
    const Ran ran = start({QStringLiteral("--screenshot"), file, QStringLiteral("--size"), QStringLiteral("1280x800")});
    RecordProperty("milliseconds", static_cast<int>(clock.elapsed()));
    EXPECT_EQ(ran.status, 0);
    EXPECT_EQ(ran.err.toStdString(), "");
    EXPECT_EQ(ran.out.toStdString(), "");
    const QImage image(file);
    EXPECT_EQ(image.size(), QSize(1280, 800));
    EXPECT_GT(colorsIn(image), 1000);
}

// With a scale factor of two everything is twice as large, including text in the panes.
TEST_F(WindowTest, AFineScreenShowsTheSameTwiceAsLarge) {
    const QTemporaryDir folder;
    std::array<QImage, 2> pictures;
    for (const int scale : {1, 2}) {
        const QString file = folder.filePath(QStringLiteral("window%1.png").arg(scale));
        const Ran ran = start({QStringLiteral("--screenshot"), file, QStringLiteral("--size"),
                               QStringLiteral("%1x%2").arg(1400 * scale).arg(900 * scale)},
                              true, QStringLiteral("C.UTF-8"), QString::number(scale));
        ASSERT_EQ(ran.status, 0) << ran.err.toStdString();
        pictures[static_cast<std::size_t>(scale - 1)] = QImage(file);
    }
    const QImage& plain = pictures[0];
    ASSERT_EQ(pictures[1].size(), 2 * plain.size());
    const QImage fine = pictures[1].scaled(plain.size(), Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
    // The pyramid's pane: on the right, below the middle.
    const QRect pane(plain.width() * 65 / 100, plain.height() * 48 / 100, plain.width() * 34 / 100,
                     plain.height() * 22 / 100);
    double sum = 0;
    for (int y = pane.top(); y <= pane.bottom(); ++y) {
        for (int x = pane.left(); x <= pane.right(); ++x) {
            sum += std::abs(qGray(plain.pixel(x, y)) - qGray(fine.pixel(x, y)));
        }
    }
    // Antialiasing of lines and letters differs by less; text of another size by much more.
    constexpr double kSmoothing = 17;
    EXPECT_LT(sum / (pane.width() * pane.height()), kSmoothing);
}

// Starts a display of this size that does not report its resolution. Returns true if the program would draw everything
// twice as large. resources: what the user has set for programs of X, as `Xft.dpi: 192`.
bool isDoubledOn(const QString& screen, const QByteArray& resources = {}) {
    QProcess server;
    server.start(QStringLiteral("Xvfb"), {QStringLiteral("-displayfd"), QStringLiteral("1"), QStringLiteral("-screen"),
                                          QStringLiteral("0"), screen});
    QByteArray number;
    while (!number.endsWith('\n') && server.waitForReadyRead(20000)) number += server.readAllStandardOutput();
    EXPECT_TRUE(number.endsWith('\n')) << "no display of " << screen.toStdString();
    const QByteArray before = qgetenv("DISPLAY");
    qputenv("DISPLAY", ":" + number.trimmed());
    QTemporaryFile settings;
    EXPECT_TRUE(settings.open() && settings.write(resources) == resources.size() && settings.flush());
    qputenv("XENVIRONMENT", settings.fileName().toLocal8Bit());
    const bool doubled = needsDoubleScale();
    qunsetenv("XENVIRONMENT");
    qputenv("QT_SCALE_FACTOR", "1");
    EXPECT_FALSE(needsDoubleScale()) << "the user has set the scale";
    qunsetenv("QT_SCALE_FACTOR");
    qputenv("DISPLAY", before);
    server.terminate();
    server.waitForFinished(5000);
    return doubled;
}

TEST_F(WindowTest, AFineScreenOfUnknownResolutionIsDrawnTwiceAsLarge) {
    if (qEnvironmentVariableIsSet("QT_SCALE_FACTOR")) GTEST_SKIP() << "a scale factor is set";
    EXPECT_TRUE(isDoubledOn(QStringLiteral("3840x2160x24")));
    EXPECT_FALSE(isDoubledOn(QStringLiteral("1920x1080x24")));
    EXPECT_TRUE(isDoubledOn(QStringLiteral("3840x2160x24"), "Xft.dpi: 96\n"));
    EXPECT_FALSE(isDoubledOn(QStringLiteral("3840x2160x24"), "Xft.dpi: 192\n")) << "Qt scales by that already";
}

}  // namespace

}  // namespace reliefui
