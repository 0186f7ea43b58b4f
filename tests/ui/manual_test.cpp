// Help opens the manual, or says how to build it.
#include <QAction>
#include <QCoreApplication>
#include <QDesktopServices>
#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QUrl>

#include "window_fixture.h"
#include "windows/manual.h"
#include "windows/message_bar.h"

namespace reliefui {

namespace {

QString makePage(const QDir& folder, const QString& place) {
    const QString path = folder.filePath(place);
    QDir().mkpath(QFileInfo(path).path());
    QFile file(path);
    EXPECT_TRUE(file.open(QFile::WriteOnly));
    return path;
}

}  // namespace

TEST(ManualPage, IsTheInstalledOneThenTheBuiltOne) {
    const QTemporaryDir temporary;
    const QDir folder(temporary.path());
    folder.mkdir(QStringLiteral("bin"));
    const QString programs = folder.filePath(QStringLiteral("bin"));
    EXPECT_EQ(manualPage(programs), QString());
    const QString built = makePage(folder, QStringLiteral("manual/html/index.html"));
    EXPECT_EQ(manualPage(programs), built);
    const QString installed = makePage(folder, QStringLiteral("share/doc/relief/html/index.html"));
    EXPECT_EQ(manualPage(programs), installed);
}

// Receives the address that would be opened in the browser.
class Browser : public QObject {
    Q_OBJECT
  public:
    Browser() { QDesktopServices::setUrlHandler(QStringLiteral("file"), this, "open"); }
    ~Browser() override { QDesktopServices::unsetUrlHandler(QStringLiteral("file")); }
    QUrl opened;

  public slots:  // NOLINT(readability-redundant-access-specifiers)
    void open(const QUrl& url) { opened = url; }
};

TEST_F(WindowTest, HelpOpensTheManualOrSaysHowItIsMade) {
    openWindow(smallScenario());
    Browser browser;
    for (QAction* action : window_->findChildren<QAction*>()) {
        if (action->text() == QStringLiteral("Man&ual")) action->trigger();
    }
    const QString page = manualPage(QCoreApplication::applicationDirPath());
    if (page.isEmpty()) {
        EXPECT_TRUE(window_->messages()->text().contains(QStringLiteral("--target manual")));
        EXPECT_TRUE(browser.opened.isEmpty());
    } else {
        EXPECT_EQ(browser.opened, QUrl::fromLocalFile(page));
    }
}

}  // namespace reliefui

#include "manual_test.moc"
