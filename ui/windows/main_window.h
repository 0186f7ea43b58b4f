// The main window: the result in the middle, around it the panes that explain it, at the bottom the time pane.
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
    // datasets: folder of the shipped pictures; may be empty.
    MainWindow(Workspace* workspace, const QString& datasets, QWidget* parent = nullptr);
    ~MainWindow() override;

    ResultView* result() { return result_; }
    // The pane of this class; null if there is none.
    template <class Pane>
    Pane* pane() const {
        return findChild<Pane*>();
    }
    TimePane* time() { return time_; }
    PixelFinder* finder() { return finder_; }
    BookmarkMenu* bookmarks() { return bookmarks_; }
    MessageBar* messages() { return messages_; }
    // A second message line, for questions to the user; it is shown and hidden by whoever asks.
    MessageBar* question() { return question_; }
    // Call this after one of the two message lines was shown or hidden.
    void showMessages();
    // Shows what can be done in the window, once per user; always: also if it was shown before.
    void welcome(bool always = false);
    TopBar* topBar() { return topBar_; }
    StatusLine* status() { return status_; }

    // Saves the rendered picture without marks in the format of the file name's ending, optionally with the layer's
    // legend below. Works in the background and reports the result as a message.
    void savePicture(const QString& path, bool legend = false);
    // Exports a view that has no export of its own: "result", "steps" or "skipped".
    void saveView(const QString& view, const FigureFile& file);

    // Stores size, panes and theme in the settings. While a pane fills the window, or in teaching or projector mode,
    // the layout that was in use before is stored.
    void keepLayout() const;
    // Restores what keepLayout() stored; without that, fits the window to the screen.
    void restoreLayout();
    // Fits the window, with its frame, to the screen.
    void fitScreen();
    // The layout that keepLayout() stores, as a value, and the reverse.
    QVariantMap layoutNow() const;
    void takeLayout(const QVariantMap& layout);
    // The arrangement of the panes, including teaching or a pane that fills the window, for the user's own layouts.
    QVariantMap arrangement() const;
    void takeArrangement(const QVariantMap& arrangement);
    bool teaching() const { return view_ == View::Teach; }

  public slots:
    // Opens the scenario of the first start. Can be undone.
    void startAnew();
    void setProjector(bool on);
    // Teaching mode: one large pane, the result in a corner, the step in words, the bar for stepping.
    void setTeaching(bool on);
    void setLightTheme(bool on);
    void resetLayout();
    void copyCommand();
    // Opens a lesson (see lessons()). Can be undone.
    void openLesson(const QString& name);
    // If the open scenario is a lesson, shows its explanation and raises its pane.
    void showLesson();

  signals:
    // The user chose another language (Qt's name of it; empty: the system's). The owner of the window has to create a
    // new one.
    void languageChosen(const QString& language);

  protected:
    bool event(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

  private:
    struct Pane {
        PaneKind kind;
        QWidget* whole = nullptr;  // the dock, or the result's widget in the middle
        QWidget* focus = nullptr;
        QDockWidget* dock = nullptr;
    };
    enum class View : std::uint8_t { All, Filled, Teach };

    void addPane(const PaneKind& kind);
    void addResult(const PaneKind& kind);
    void addTableMenus();
    void styleTabs();
    QDockWidget* dockOf(const QString& pane) const;
    // The first dock at this place, which is initially in front.
    QDockWidget* front(DockPlace place) const;
    static QString paneKey(std::size_t pane);
    PaneTitle* titleOf(const PaneKind& kind, QWidget* whole);
    void makeMessages();
    void report(const QString& text, bool problem);
    void dropStaleMessage();
    void arrange();
    void arrange(bool projector);
    DockPlace placeOf(const Pane& pane) const;
    QDockWidget* activePane() const;
    void shareRoom();
    void closePane(QWidget* whole);
    void emptyClosed();
    void fill(QWidget* pane);
    QDockWidget* visiblePane() const;
    void keepInFront(QDockWidget* pane);
    void showView(View view, QWidget* pane = nullptr);
    void adaptToView();
    void restoreKept();
    void restorePanes(const QByteArray& state);
    void applyType(const Style& style);
    void focusWhole(QWidget* whole);
    void focusPane(std::size_t number);
    void focusPane(const QString& name);
    // View of the pane that fills the window, otherwise the result.
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
    void cancel();
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
    bool arranged_ = false;  // the layout is that of the plan, without changes by the user
    View view_ = View::All;
    QWidget* filled_ = nullptr;  // null if no pane fills the window
    // State of the panes on the desktop [0] and the projector [1] while something else is shown; empty: as in the plan.
    std::array<QByteArray, 2> kept_;
    QByteArray place_;                  // geometry of the window outside projector mode
    StepSentence* sentence_ = nullptr;  // shown below the result while teaching
    HomeView* home_ = nullptr;
    // The pictures and the version that the current message refers to.
    std::optional<relief::Pictures> messagePictures_;
    std::uint64_t messageVersion_ = 0;
    QTimer* closed_ = nullptr;  // empties closed panes after a delay
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
