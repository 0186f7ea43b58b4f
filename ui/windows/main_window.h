// The window: the result in the middle, the panes that explain it around, time below.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include <QMainWindow>
#include <QVariantMap>

#include "windows/layout_plan.h"
#include "windows/pane_list.h"
#include "workspace/mailbox.h"
#include "workspace/workspace.h"

class QDockWidget;
class QMenu;
class QTimer;
class QToolBar;

namespace reliefui {

class FigureView;
class KeyPolicy;
class BookmarkMenu;
class HomeView;
class MessageBar;
struct FigureFile;
struct Lesson;
class PaneTitle;
class PixelFinder;
class ResultView;
class StatusLine;
class StepSentence;
class TimePane;
class TopBar;

class MainWindow : public QMainWindow {
    Q_OBJECT
  public:
    // datasets: the folder of the shipped pictures; may be empty.
    MainWindow(Workspace* workspace, const QString& datasets, QWidget* parent = nullptr);
    ~MainWindow() override;

    ResultView* result() { return result_; }
    // One of the panes around it, by its class.
    template <class Pane>
    Pane* pane() const {
        return findChild<Pane*>();
    }
    TimePane* time() { return time_; }
    PixelFinder* finder() { return finder_; }
    BookmarkMenu* bookmarks() { return bookmarks_; }
    MessageBar* messages() { return messages_; }
    // A line of its own below, for what asks for an answer; shown and hidden by whoever asks.
    MessageBar* question() { return question_; }
    // To be called when one of the two was shown or hidden.
    void showMessages();
    // What somebody who sees the window for the first time may do with it; once in a user's life.
    void welcome();
    TopBar* topBar() { return topBar_; }
    StatusLine* status() { return status_; }

    // The drawn picture as it is, without marks, in the format of its ending, on request with the layer's legend below;
    // says when it is done, or why not.
    void savePicture(const QString& path, bool legend = false);
    // One of the views that have no export of their own: "result", "steps", "skipped".
    void saveView(const QString& view, const FigureFile& file);

    // Size, panes and theme, from one window to the next, in the settings. A pane that fills the window, teaching and
    // the projector's layout are not kept: what was there before them is.
    void keepLayout() const;
    // Where nothing is kept, the window fits the screen.
    void restoreLayout();
    // The same as a value.
    QVariantMap layoutNow() const;
    void takeLayout(const QVariantMap& layout);
    // Where the panes are, also while one fills the window or is taught with: a layout of one's own.
    QVariantMap arrangement() const;
    void takeArrangement(const QVariantMap& arrangement);
    bool teaching() const { return view_ == View::Teach; }

  public slots:
    // The shipped pictures as they were the first time; can be undone.
    void startAnew();
    void setProjector(bool on);
    // One pane large, the result in a corner, the step in words, the bar that steps.
    void setTeaching(bool on);
    void setLightTheme(bool on);
    void resetLayout();
    void copyCommand();
    // Opens a lesson (lessons()); can be undone.
    void openLesson(const QString& name);
    // Where the open scenario is a lesson: what it shows is said, its pane comes to the front.
    void showLesson();

  signals:
    // Another language was chosen in the menu, as Qt names it; empty: the system's. Who made the window makes it anew.
    void languageChosen(const QString& language);

  protected:
    bool event(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

  private:
    struct Pane {
        PaneKind kind;
        QWidget* whole = nullptr;  // the dock, or the middle
        QWidget* focus = nullptr;
        QDockWidget* dock = nullptr;
    };
    enum class View : std::uint8_t { All, Filled, Teach };

    void addPane(const PaneKind& kind);
    void addResult(const PaneKind& kind);
    void addTableMenus();
    void dressTabs();
    QDockWidget* dockOf(const QString& pane) const;
    // The dock that stands in front there at first.
    QDockWidget* front(DockPlace place) const;
    static QString paneKey(std::size_t pane);
    PaneTitle* titleOf(const PaneKind& kind, QWidget* whole);
    void makeMessages();
    void tell(const QString& text, bool problem);
    void dropStaleMessage();
    void arrange();
    DockPlace placeOf(const Pane& pane) const;
    QDockWidget* lookedAt() const;
    void shareRoom();
    void closePane(QWidget* whole);
    void emptyClosed();
    void fill(QWidget* pane);
    void showView(View view, QWidget* pane = nullptr);
    void dressForView();
    void restoreKept();
    void restorePanes(const QByteArray& state);
    void takeType(const Style& style);
    void fitScreen();
    void focusWhole(QWidget* whole);
    void focusPane(std::size_t number);
    void focusPane(const QString& name);
    // Of the pane that fills the window; else the result.
    QWidget* frontView() const;

    void makeMenus();
    void makeFileMenu();
    void makeEditMenu();
    void makeViewMenu();
    void makeLanguageMenu(QMenu* menu);
    void makeRayMenu();
    void makeWorthMenu(QMenu* menu);
    void makeDuelMenu(QMenu* menu);
    void makeBookmarkMenu(QMenu* menu);
    void showBookmarks();
    void askOtherTracer();
    void makeLessonMenu();
    void showLesson(const Lesson& lesson);
    void makeHelpMenu();
    QAction* addAction(QMenu* menu, const QString& text, const QKeySequence& keys, const QString& help);
    void fillRecent();
    void fillExamples(QMenu* menu);
    void remember(const QString& path);
    void refreshTitles();
    void resultMenu(const QPoint& global);
    void askOpen();
    void askColor();
    void askSaveScenario();
    void askSavePicture(bool legend = false);
    void askPixel();
    void askView(const QString& view);
    void exportFocused();
    void showShortcuts();
    void showManual();
    void showPauses();
    void showAbout();

    Workspace* workspace_;
    QString datasets_;
    KeyPolicy* keys_ = nullptr;
    ResultView* result_ = nullptr;
    TimePane* time_ = nullptr;
    PixelFinder* finder_ = nullptr;
    BookmarkMenu* bookmarks_ = nullptr;
    MessageBar* messages_ = nullptr;
    MessageBar* question_ = nullptr;
    QToolBar* messageRow_ = nullptr;
    QAction* messageHolder_ = nullptr;
    StatusLine* status_ = nullptr;
    TopBar* topBar_ = nullptr;
    std::vector<Pane> panes_;
    LayoutPlan plan_;
    bool arranged_ = false;  // as the plan has it, and nobody has changed it
    View view_ = View::All;
    QWidget* filled_ = nullptr;  // the pane that fills the window
    // The panes of the desktop and of the projector while something else is shown; empty: as the plan has them.
    std::array<QByteArray, 2> kept_;
    QByteArray place_;                  // of the window that is not on the projector
    StepSentence* sentence_ = nullptr;  // below the result while teaching
    HomeView* home_ = nullptr;
    // What the message speaks of.
    std::optional<relief::Pictures> messagePictures_;
    std::uint64_t messageVersion_ = 0;
    QTimer* closed_ = nullptr;  // runs when a pane has been closed, to empty it
    QMenu* recent_ = nullptr;
    QAction* open_ = nullptr;
    QAction* undo_ = nullptr;
    QAction* redo_ = nullptr;
    QAction* projector_ = nullptr;
    QAction* teach_ = nullptr;
    QAction* light_ = nullptr;
    QAction* copyCommand_ = nullptr;
    Mailbox mailbox_{this};
};

}  // namespace reliefui
