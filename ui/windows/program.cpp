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

// The implementations that VTK chooses at run time. Not by vtk_module_autoinit: it gives every source a macro with a
// path of this checkout, and the compiler cache could not serve another.
VTK_MODULE_INIT(vtkInteractionStyle)
VTK_MODULE_INIT(vtkRenderingFreeType)
VTK_MODULE_INIT(vtkRenderingOpenGL2)

// Resources of a static library have to be asked for, outside any namespace.
static void initTranslations() {
    Q_INIT_RESOURCE(translations);
}

namespace reliefui {

namespace {

// After the first full picture: until the panes have drawn it as well.
constexpr int kPanesDrawnMs = 800;

// Qt complains about its absence.
void giveRuntimeFolder() {
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
    if (!done) std::fprintf(stderr, "relief: %s\n", relief::sentence(fault, uiLanguage()).c_str());
    QApplication::exit(done ? 0 : 1);
}

}  // namespace

void prepareWindows() {
    // VTK here draws through GLX: X11, also where a Wayland session would offer something else.
    if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "xcb");
    giveRuntimeFolder();
    // On fine screens everything is as large as the desktop says; where it says nothing, as large as can be read.
    if (wantsTwiceTheSize()) qputenv("QT_SCALE_FACTOR", "2");
    QApplication::setAttribute(Qt::AA_EnableHighDpiScaling);
    QApplication::setAttribute(Qt::AA_UseHighDpiPixmaps);
    QSurfaceFormat format = QVTKOpenGLNativeWidget::defaultFormat();
    format.setSamples(0);
    QSurfaceFormat::setDefaultFormat(format);
}

void prepareFigures() {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    giveRuntimeFolder();
}

void dressApplication(QApplication&) {
    std::setlocale(LC_NUMERIC, "C");
    initTranslations();
    QApplication::setApplicationName(QStringLiteral("reliefscope"));
    QApplication::setOrganizationName(QStringLiteral("reliefscope"));
    speak({});
    QApplication::setStyle(new WindowStyle);
    QApplication::setPalette(themePalette(Theme::Dark));
    QApplication::setFont(windowFont(1));
}

void speak(const QString& language) {
    QLocale::setDefault(language.isEmpty() ? QLocale::system() : QLocale(language));
    for (QTranslator* const old : QCoreApplication::instance()->findChildren<QTranslator*>()) delete old;
    const auto add = [](const QString& file, const QString& folder) {
        auto* const texts = new QTranslator(QCoreApplication::instance());
        const bool found = texts->load(QLocale(), file, QStringLiteral("_"), folder);
        if (found) QCoreApplication::installTranslator(texts);
        return found;
    };
    if (add(QStringLiteral("reliefscope"), QStringLiteral(":/translations"))) {
        add(QStringLiteral("qtbase"), QLibraryInfo::location(QLibraryInfo::TranslationsPath));
    } else {
        // English, the language of what has no translation, has plural forms as well.
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
