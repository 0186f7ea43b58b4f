#include "windows/program.h"

#include <unistd.h>
#include <clocale>
#include <cstdio>

#include <QVTKOpenGLNativeWidget.h>
#include <vtkAutoInit.h>
#include <QDir>
#include <QLibraryInfo>
#include <QLocale>
#include <QPixmap>
#include <QStandardPaths>
#include <QSurfaceFormat>
#include <QTimer>
#include <QTranslator>

#include "windows/display_check.h"
#include "windows/main_window.h"
#include "windows/theme.h"
#include "windows/window_style.h"
#include "workspace/language.h"

// VTK modules whose implementations are chosen at run time. vtk_module_autoinit is not used: it passes a macro with a
// path of this checkout to every source file, which would defeat the compiler cache in other checkouts.
VTK_MODULE_INIT(vtkInteractionStyle)
VTK_MODULE_INIT(vtkRenderingFreeType)
VTK_MODULE_INIT(vtkRenderingOpenGL2)

// Resources of a static library have to be initialised explicitly, outside any namespace.
static void initTranslations() {
    Q_INIT_RESOURCE(translations);
}

namespace reliefui {

namespace {

// Time for the panes to draw themselves after the first full picture.
constexpr int kPanesDrawnMs = 800;

// Creates the runtime folder, because Qt prints a warning if it is missing.
void createRuntimeFolder() {
    if (!qEnvironmentVariableIsEmpty("XDG_RUNTIME_DIR")) return;
    const QString folder = QDir::tempPath() + QStringLiteral("/runtime-%1").arg(getuid());
    QDir().mkpath(folder);
    QFile::setPermissions(folder, QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
    qputenv("XDG_RUNTIME_DIR", folder.toLocal8Bit());
}

void grab(MainWindow& window, const QString& path) {
    const bool done = window.grab().save(path, "PNG");
    const relief::Message fault(relief::MessageId::SubjectSays,
                                {{"subject", path.toStdString()}, {"why", relief::MessageId::WindowUnsaved}});
    if (!done) std::fprintf(stderr, "reliefscope: %s\n", relief::sentence(fault, uiLanguage()).c_str());
    QApplication::exit(done ? 0 : 1);
}

// Qt writes the fonts of a PDF in the order of a hash table, which is random unless this is set.
void fixOrderInFiles() {
    qSetGlobalQHashSeed(0);
}

}  // namespace

void prepareWindows() {
    fixOrderInFiles();
    // VTK draws through GLX, so X11 is required, even in a session that offers Wayland.
    if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "xcb");
    createRuntimeFolder();
    // On high-resolution screens Qt follows the desktop's scale; if the desktop sets none, everything is doubled.
    if (needsDoubleScale()) qputenv("QT_SCALE_FACTOR", "2");
    QApplication::setAttribute(Qt::AA_EnableHighDpiScaling);
    QApplication::setAttribute(Qt::AA_UseHighDpiPixmaps);
    QSurfaceFormat format = QVTKOpenGLNativeWidget::defaultFormat();
    format.setSamples(0);
    QSurfaceFormat::setDefaultFormat(format);
}

void prepareFigures() {
    fixOrderInFiles();
    qputenv("QT_QPA_PLATFORM", "offscreen");
    createRuntimeFolder();
}

void setUpApplication(QApplication&) {
    std::setlocale(LC_NUMERIC, "C");
    initTranslations();
    QApplication::setApplicationName(QStringLiteral("reliefscope"));
    QApplication::setOrganizationName(QStringLiteral("reliefscope"));
    installTranslations({});
    QApplication::setStyle(new WindowStyle);
    QApplication::setPalette(themePalette(Theme::Dark));
    QApplication::setFont(windowFont(1));
}

// Qt's own Ukrainian name of this key means a gap.
[[maybe_unused]] constexpr const char* kSpaceKey = QT_TRANSLATE_NOOP("QShortcut", "Space");

void installTranslations(const QString& language) {
    QLocale::setDefault(language.isEmpty() ? QLocale::system() : QLocale(language));
    for (QTranslator* const old : QCoreApplication::instance()->findChildren<QTranslator*>()) delete old;
    const auto loaded = [](const QString& file, const QString& folder) {
        auto* const texts = new QTranslator(QCoreApplication::instance());
        return texts->load(QLocale(), file, QStringLiteral("_"), folder) ? texts : nullptr;
    };
    if (auto* const own = loaded(QStringLiteral("reliefscope"), QStringLiteral(":/translations"))) {
        auto* const qt = loaded(QStringLiteral("qtbase"), QLibraryInfo::location(QLibraryInfo::TranslationsPath));
        if (qt != nullptr) QCoreApplication::installTranslator(qt);
        // Searched first, because it was installed last: it has better names for some keys.
        QCoreApplication::installTranslator(own);
    } else {
        // English needs a translation file as well, for its plural forms.
        auto* const plurals = new QTranslator(QCoreApplication::instance());
        if (plurals->load(QStringLiteral(":/translations/reliefscope_en.qm"))) {
            QCoreApplication::installTranslator(plurals);
        }
    }
}

void screenshotThenQuit(MainWindow& window, Workspace& workspace, const QString& path) {
    const auto takeWhenIdle = [&window, path](bool busy) {
        if (!busy) QTimer::singleShot(kPanesDrawnMs, &window, [&window, path] { grab(window, path); });
    };
    QObject::connect(&workspace, &Workspace::busyChanged, &window, takeWhenIdle);
}

}  // namespace reliefui
