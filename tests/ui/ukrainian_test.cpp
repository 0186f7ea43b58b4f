// The Ukrainian texts: no English is left in them, they use the papers' terms, and one word per concept.
#include <algorithm>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDirIterator>
#include <QFile>
#include <QKeySequence>
#include <QLabel>
#include <QRegularExpression>
#include <QTranslator>
#include <QXmlStreamReader>

#include "filtering/filters/filter_choice.h"
#include "relief/messages.h"
#include "relief/reliefs.h"
#include "relief/tracers.h"
#include "relief/tracers/map_choice.h"
#include "scenario/row_methods.h"
#include "window_fixture.h"
#include "windows/program.h"

namespace reliefui {

namespace {

struct Text {
    QString english;
    QString ukrainian;
};

// Returns all texts of the .ts files and of the table of messages; each plural form is a text.
std::vector<Text> allTexts() {
    std::vector<Text> texts;
    for (const char* const name : {"reliefscope_uk.ts", "algorithms_uk.ts"}) {
        QFile file(QStringLiteral(RELIEF_SOURCE "/ui/") + QLatin1String(name));
        if (!file.open(QIODevice::ReadOnly)) ADD_FAILURE() << name;
        QXmlStreamReader xml(&file);
        QString source;
        while (!xml.atEnd()) {
            if (xml.readNext() != QXmlStreamReader::StartElement) continue;
            if (xml.name() == QLatin1String("source")) source = xml.readElementText();
            if (xml.name() != QLatin1String("translation") && xml.name() != QLatin1String("numerusform")) continue;
            // A translation with plural forms has no text of its own.
            if (xml.readNext() == QXmlStreamReader::Characters && !xml.isWhitespace()) {
                texts.push_back({source, xml.text().toString()});
            }
        }
    }
    for (int id = 0; id < static_cast<int>(relief::MessageId::Count); ++id) {
        const auto said = [&](relief::Language language) {
            const std::string_view text = relief::messageTemplate(static_cast<relief::MessageId>(id), language);
            return QString::fromUtf8(text.data(), static_cast<int>(text.size()));
        };
        texts.push_back({said(relief::Language::English), said(relief::Language::Ukrainian)});
    }
    return texts;
}

void addWords(std::set<QString>& words, const std::string& text) {
    static const QRegularExpression word(QStringLiteral("[A-Za-z][A-Za-z0-9]*"));
    for (auto all = word.globalMatch(QString::fromStdString(text)); all.hasNext();) words.insert(all.next().captured());
}

void addOptions(std::set<QString>& words, const std::vector<relief::OptionDescription>& options) {
    for (const relief::OptionDescription& option : options) {
        addWords(words, option.name);
        for (const std::string& choice : option.choices) addWords(words, choice);
    }
}

// Words that are typed literally: names of methods, options and their values, files and columns; of keys; of measures,
// formats and papers.
const std::set<QString>& allowedWords() {
    static const std::set<QString> words = [] {
        std::set<QString> all;
        addWords(all,
                 "Reliefscope reliefscope relief bench tracers trace render merge stress map tile "  // commands
                 "Alt Ctrl Down End Enter Esc Home Page Shift Tab Up "
                 "English "  // in the menu of languages, each in its own
                 "certify export rays "
                 "EGL Debian libegl1 libgl1 mesa dri "                 // of the graphics driver
                 "hlsl FILE png orbit sweep profile "                  // values of options, of files
                 "worst shift fetches verdict build time "             // columns of the advice for shaders
                 "delta level pixel value "                            // columns of steps, in conditions
                 "choose hit knob lesson method number options "       // keys of lessons
                 "apex sqrt ratio HLSL glslangValidator spirv cross "  // of maps for engines and shaders
                 "outcome unknown sRGB textureGrad textureLod "        // of files, of other programs
                 "CPU DIST17 FLIP MIP MIP18 MPI OpenGL GLX PERSP PSNR RMSE SIMD TEX "
                 "CSV HTML JSON PDF PNG SVG TIFF csv exr html json "
                 "DISPLAY HI LO auto beyond border clamp double error false float full random reads repeat true "
                 "lambda_in lambda_out layers mapping parallax bump normal MiB px");
        for (const relief::MethodDescription& method : relief::tracerList()) {
            addWords(all, method.name);
            addOptions(all, method.options);
        }
        for (const relief::FilterDescription& filter : relief::filterList()) {
            addWords(all, filter.name);
            addOptions(all, filter.options);
        }
        for (const relief::RowMethodDescription& row : relief::rowMethodList()) {
            addWords(all, row.name);
            addOptions(all, row.options);
        }
        for (const relief::ReliefRecipe& recipe : relief::reliefRecipes()) addWords(all, std::string(recipe.name));
        for (const std::string& map : relief::mapKinds()) addWords(all, map);
        return all;
    }();
    return words;
}

// Returns the Latin words that are neither allowed nor symbols (u, S0, F11, u_x) nor command-line options.
QStringList foreignWords(QString text) {
    static const QRegularExpression holes(QStringLiteral("\\{\\w+\\}|%(\\d|n)|<[^>]*>|--[a-z-]+|800x600|\\d+e-?\\d+"));
    static const QRegularExpression word(QStringLiteral("[A-Za-z][A-Za-z0-9]*"));
    text.remove(QLatin1Char('&')).replace(holes, QStringLiteral(" "));
    QStringList found;
    for (auto all = word.globalMatch(text); all.hasNext();) {
        const QString one = all.next().captured();
        const bool symbol = std::all_of(one.begin() + 1, one.end(), [](QChar c) { return c.isDigit(); });
        const bool symbols = one == one.toLower() && one.size() == 2 && text.contains(one[0] + QLatin1Char('_'));
        if (!symbol && !symbols && allowedWords().count(one) == 0) found << one;
    }
    return found;
}

bool isUkrainian(const QString& text) {
    static const QRegularExpression letters(QStringLiteral("[А-Яа-яІіЇїЄєҐґ]"));
    return text.contains(letters);
}

}  // namespace

// Names in the undo history, and of logged pauses, must be translated again after a change of language
// (workspace/change_name.h).
TEST(Ukrainian, NamesOfChangesAndPartsAreTranslatedAgain) {
    const QRegularExpression changes(
        QStringLiteral("\\b(?:workspace_?(?:\\(\\))?(?:->|\\.)(?:show|setBreakpoints|setBookmarks)|past_\\.push|change)"
                       "\\(([^;]*);"));
    const QRegularExpression parts(QStringLiteral("(?:PauseLog::Part|DrawingTime) \\w+\\(\"([^\"]+)\""));
    const auto text = [](const QString& path) {
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
    };
    const QString named = text(QStringLiteral(RELIEF_SOURCE "/ui/workspace/pause_log.cpp"));
    int found = 0;
    for (QDirIterator files(QStringLiteral(RELIEF_SOURCE "/ui"), {QStringLiteral("*.cpp")}, QDir::Files,
                            QDirIterator::Subdirectories);
         files.hasNext();) {
        const QString path = files.next();
        const QString source = text(path);
        for (auto all = changes.globalMatch(source); all.hasNext();) {
            const QString call = all.next().captured(1);
            EXPECT_FALSE(call.contains(QStringLiteral("tr(\"")) && !call.contains(QStringLiteral("changeName(")))
                << path.toStdString() << ": changeName() must translate this name: " << call.toStdString();
            found += call.contains(QStringLiteral("changeName(")) ? 1 : 0;
        }
        for (auto all = parts.globalMatch(source); all.hasNext();) {
            const QString part = all.next().captured(1);
            EXPECT_TRUE(named.contains(QStringLiteral("\"parts\", \"%1\"").arg(part)))
                << "the list in ui/workspace/pause_log.cpp lacks: " << part.toStdString();
        }
    }
    EXPECT_GT(found, 30);
}

TEST(Ukrainian, NoEnglishIsLeftInTheTexts) {
    EXPECT_EQ(foreignWords(QStringLiteral("{method}, step &open: λ %1 S0 u_x layers")), QStringList({"step", "open"}));
    const std::vector<Text> texts = allTexts();
    EXPECT_GT(texts.size(), 1000U);
    for (const Text& text : texts) {
        EXPECT_EQ(foreignWords(text.ukrainian).join(' ').toStdString(), "") << text.ukrainian.toStdString();
        const bool sentence = foreignWords(text.english).size() > 1;
        EXPECT_TRUE(!sentence || isUkrainian(text.ukrainian)) << text.english.toStdString();
    }
}

// An English term, and the stems of which one must occur in the Ukrainian text; names of methods are excluded.
TEST(Ukrainian, ATermHasOneTranslation) {
    struct Term {
        const char* english;
        const char* ukrainian;
    };
    const std::vector<Term> terms{{"footprint", "проєкц|основ"},
                                  {"view ray", "видов"},
                                  {"maximum pyramid", "MIP-пірамід"},
                                  {"max pyramid", "MIP-пірамід"},
                                  {"relief slab", "товщ|рельєф"},
                                  {"conservative", "консервативн"},
                                  {"overshoot", "проскок"},
                                  {"voxel", "вокс"},
                                  {"breakpoint", "точ.?к"},
                                  {"bookmark", "заклад"},
                                  {"step limit", "меж"},
                                  {"unsafe map", "ненадійна карта"},
                                  {"missed spike", "непомічений шпиль"},
                                  {"interpolation leak", "хибний перетин через інтерполяцію"},
                                  {"stages", "етап"},
                                  {"elevation", "кут|піднесення"},
                                  {"exact hit", "точн"},
                                  {"texture coordinates", "текстурн(і|их) координат"}};
    const QRegularExpression names(QStringLiteral("[a-z]+-[a-z-]+|\\{\\w+\\}"));
    for (const Text& text : allTexts()) {
        const QString english = QString(text.english).remove(names).remove('&');
        const QString ukrainian = QString(text.ukrainian).remove('&');
        if (text.english == text.ukrainian) continue;
        for (const Term& term : terms) {
            if (!english.contains(QString::fromUtf8(term.english), Qt::CaseInsensitive)) continue;
            const QRegularExpression said(QString::fromUtf8(term.ukrainian), QRegularExpression::CaseInsensitiveOption);
            EXPECT_TRUE(ukrainian.contains(said)) << text.english.toStdString() << '\n' << text.ukrainian.toStdString();
        }
    }
}

// Words that the papers do not use for these concepts, misspellings, typewriter apostrophes, % without a space.
TEST(Ukrainian, TermsAreUsedConsistently) {
    const QRegularExpression wrong(
        QString::fromUtf8(
            "картинк|малюнк|влуча|клітин|обережн|тексели|істин|схова|здогад|вгада|піксел(?![іюяье])|проекц|"
            "відбит|простеж|зсув|колес|гаус(?!івськ)|[а-яіїєґ]'[а-яіїєґ]|[\\d}]%| …|3-D"),
        QRegularExpression::CaseInsensitiveOption | QRegularExpression::UseUnicodePropertiesOption);
    ASSERT_TRUE(wrong.isValid()) << wrong.errorString().toStdString();
    for (const Text& text : allTexts()) {
        const QString ukrainian = QString(text.ukrainian).remove('&');
        EXPECT_EQ(wrong.match(ukrainian).captured().toStdString(), "") << ukrainian.toStdString();
    }
}

// Names, units and help texts of numbers, methods, filters and their options.
TEST(Ukrainian, TheAlgorithmsDescribeThemselvesInIt) {
    QTranslator translator;
    ASSERT_TRUE(translator.load(QStringLiteral(":/translations/reliefscope_uk.qm")));
    const auto expectText = [&](const std::string& english) {
        EXPECT_TRUE(english.empty() || isUkrainian(translator.translate("core", english.c_str())))
            << "ui/algorithms_uk.ts has no translation of: " << english;
    };
    const auto expectTitle = [&](const std::string& english) {
        const QString title = translator.translate("core", english.c_str(), "title");
        EXPECT_TRUE(isUkrainian(title)) << english;
    };
    const auto expectOption = [&](const relief::OptionDescription& option) {
        std::string title = option.name;
        for (char& c : title) c = c == '-' ? ' ' : c;
        title.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(title.front())));
        if (translator.translate("core", title.c_str(), "option").isEmpty()) expectText(title);
        expectText(option.help);
        expectText(option.unit);
    };
    for (const relief::ScenarioNumber& number : relief::scenarioNumbers()) expectOption(number.description);
    for (const relief::MethodDescription& method : relief::tracerList()) {
        expectText(method.title);
        expectText(method.help);
        expectTitle(method.title);
        for (const relief::OptionDescription& option : method.options) expectOption(option);
    }
    for (const relief::FilterDescription& filter : relief::filterList()) {
        expectText(filter.help);
        expectTitle(filter.title);
        for (const relief::OptionDescription& option : filter.options) expectOption(option);
    }
    for (const relief::RowMethodDescription& row : relief::rowMethodList()) {
        if (std::holds_alternative<relief::RowVariant>(row.kind)) expectText(row.help);
    }
    for (const relief::ReliefRecipe& recipe : relief::reliefRecipes()) {
        expectText(std::string(recipe.help));
        expectTitle(std::string(recipe.title));
    }
    // A method's title and the unit of its option, the same word in English.
    EXPECT_NE(translator.translate("core", "layers", "title"), translator.translate("core", "layers"));
    for (const std::string& map : relief::mapKinds()) expectText("map " + map);
}

// Qt's own translation of the key means a gap.
TEST(Ukrainian, TheSpaceKeyIsNamedAsOnTheKeyboard) {
    if (!haveDisplay()) GTEST_SKIP();
    installTranslations(QStringLiteral("uk"));
    const QString key = QKeySequence(Qt::Key_Space).toString(QKeySequence::NativeText);
    installTranslations({});
    EXPECT_EQ(key.toStdString(), "Пробіл");
}

TEST_F(WindowTest, AUkrainianWindowHasNoEnglish) {
    QTranslator translator;
    ASSERT_TRUE(translator.load(QStringLiteral(":/translations/reliefscope_uk.qm")));
    const QLocale before;
    QLocale::setDefault(QLocale(QLocale::Ukrainian));
    QApplication::installTranslator(&translator);
    openWindow(deepRay());
    QTest::qWait(300);
    const auto expectForeignless = [](const QString& text) {
        // Paths, commands and names of pictures are quoted unchanged.
        if (text.contains('/') || (text.contains('_') && !text.contains(' '))) return;
        EXPECT_EQ(foreignWords(text).join(' ').toStdString(), "") << text.toStdString();
    };
    int seen = 0;
    for (const QWidget* const widget : window_->findChildren<QWidget*>()) {
        // Qt's own widgets: the buttons of a dock, hidden behind our title, and of tab bars.
        const QString name = widget->objectName();
        if (name.startsWith(QLatin1String("qt_dockwidget")) || name.startsWith(QLatin1String("Scroll"))) continue;
        expectForeignless(widget->toolTip());
        expectForeignless(widget->accessibleName());
        if (const auto* const label = qobject_cast<const QLabel*>(widget)) expectForeignless(label->text()), ++seen;
        if (const auto* const button = qobject_cast<const QAbstractButton*>(widget)) expectForeignless(button->text());
        const auto* const box = qobject_cast<const QComboBox*>(widget);
        for (int n = 0; box != nullptr && n < box->count(); ++n) expectForeignless(box->itemText(n));
    }
    for (const QAction* const action : window_->findChildren<QAction*>()) expectForeignless(action->text()), ++seen;
    for (const QWidget* const menu : window_->findChildren<QWidget*>()) {
        if (!menu->inherits("QMenu") && !menu->inherits("QMenuBar")) continue;
        std::set<QChar> letters;
        for (const QAction* const action : menu->actions()) {
            const int at = action->text().indexOf('&');
            if (at < 0 || action->text().mid(at, 2) == QLatin1String("&&")) continue;
            EXPECT_TRUE(letters.insert(action->text()[at + 1].toLower()).second) << action->text().toStdString();
        }
    }
    EXPECT_GT(seen, 100);
    window_.reset();
    workspace_.reset();
    QApplication::removeTranslator(&translator);
    QLocale::setDefault(before);
}

}  // namespace reliefui
