// The window's one model: the open scenario, the chosen pixel, ray and step, undo as a history of scenario values, and
// the render worker. Views look at it and ask it for changes; they never talk to each other.
//
// Everything that computes runs on the worker's thread; the latest request wins. Results carry the version of the
// scenario they were made from, and arrive together, so that panes never mix two states. Pictures are loaded before
// they become part of the scenario; whatever turns out impossible later takes the scenario back to the last state that
// was shown: window and scenario never disagree.
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <vector>

#include <QObject>
#include <QString>

#include "painting/style.h"
#include "workspace/background_tasks.h"
#include "workspace/history.h"
#include "workspace/snapshot.h"

namespace reliefui {

struct StateReaders;

class RenderWorker;
struct LoadResult;
struct RenderFailure;

class Workspace : public QObject {
    Q_OBJECT
  public:
    // readers: of the panes' states, which scenarios are checked with; null: they are taken as they stand.
    explicit Workspace(std::shared_ptr<const StateReaders> readers = nullptr, QObject* parent = nullptr);
    ~Workspace() override;

    // The first scenario. `store`: pictures that are loaded already.
    void start(const relief::Scenario& scenario, relief::AssetStore store = {});

    const relief::Scenario& scenario() const { return scenario_; }
    std::uint64_t version() const { return version_; }
    // The newest complete state; null before the first.
    std::shared_ptr<const Snapshot> snapshot() const { return guessing_ && hidden_ ? hidden_ : snapshot_; }

    // A new scenario value. Changes with the same non-empty mergeKey in a row (a drag) become one step of undo. While
    // `live`, a coarse picture is drawn first. An impossible value is refused with problem() and changes nothing.
    void change(const relief::Scenario& scenario, const QString& what, const QString& mergeKey = {}, bool live = false);
    // Ends a run of merged changes (mouse released): the full picture is drawn.
    void settle();
    // Chooses a pixel (clamped to the picture) and the first step of its ray, or a step. Part of the undo history as
    // well.
    void choosePixel(int x, int y);
    void chooseStep(int step);
    // The last step instead, of each pixel that is chosen; not part of the scenario.
    bool raysFromEnd() const { return raysFromEnd_; }
    void setRaysFromEnd(bool on) { raysFromEnd_ = on; }

    // Where stepping stops, and pixels worth coming back to: entries of the undo history as well, nothing is rendered.
    void setBreakpoints(std::vector<relief::Breakpoint> breakpoints, const QString& what);
    void setBookmarks(std::vector<relief::Bookmark> bookmarks, const QString& what);
    // Its camera, pixel and step.
    void goTo(const relief::Bookmark& bookmark);

    // The texel of the footprint's list that is pointed at, so that all panes that name one name it; none: the pointer
    // is elsewhere. Not part of the scenario; nothing is computed anew.
    std::optional<std::size_t> texel() const { return texel_; }
    void pointAtTexel(std::optional<std::size_t> texel);

    // While somebody guesses where the ray hits, snapshots come without its hit and its steps; not part of the
    // scenario.
    bool guessing() const { return guessing_; }
    void setGuessing(bool on);

    // What the result view shows of the frame; not part of the scenario.
    Layer layer() const { return layer_; }
    void setLayer(Layer layer);
    // The pyramid that is looked at: of large pictures no other is built.
    void setLevels(relief::PyramidKind levels);
    // How panes are drawn (theme, projector, language); not part of the scenario.
    const Style& style() const { return style_; }
    void setStyle(const Style& style);

    bool canUndo() const { return past_.canUndo(); }
    bool canRedo() const { return past_.canRedo(); }
    QString undoText() const { return canUndo() ? past_.current().what : QString(); }
    QString redoText() const { return canRedo() ? past_.redone().what : QString(); }

    // Opens a picture (height map) or a scenario file (.json). On an error: problem(), everything as it was.
    void open(const QString& path);
    // A whole scenario, its step included, as if it were opened from a file; `what` names it in the history.
    void show(const relief::Scenario& scenario, const QString& what);
    void save(const QString& path);
    // What takes long beside the pictures, such as figures; cancel() cancels it, too.
    BackgroundTasks& tasks() { return tasks_; }
    QString traceCommand() const;  // the `relief trace` line of the chosen pixel
    bool busy() const;
    // What a pane says while there is no picture: it is being computed, or none is open.
    relief::MessageId whyEmpty() const {
        return busy() ? relief::MessageId::DrawCompareDrawing : relief::MessageId::DrawNoPicture;
    }
    // Pictures of a scenario that is asked for are being read: it is not there yet.
    bool loading() const { return pending_.has_value(); }

  public slots:
    void undo();
    void redo();
    void cancel();

  signals:
    void scenarioChanged();      // at once, before anything is computed
    void snapshotChanged();      // a new state is on screen
    void stepChanged(int step);  // only the chosen step changed
    void notesChanged();         // only breakpoints or bookmarks changed
    void panesChanged();         // what is chosen in the panes; by undo, too, or with another scenario
    void texelChanged();         // another one is pointed at
    void guessingChanged(bool on);
    void styleChanged();                                  // repaint
    void progress(const QString& what, double fraction);  // fraction < 0: done
    void problem(const QString& oneLine);                 // to be shown; nothing changed
    void notice(const QString& oneLine);                  // to be shown; what was done to the pictures
    void opened(const QString& path);                     // a file was opened
    void busyChanged(bool busy);

  private:
    const std::shared_ptr<const StateReaders> readers_;
    enum class Action : std::uint8_t { Start, Open, Change, Undo, Redo };
    // What happens when the pictures that it needs are loaded.
    struct Pending {
        std::uint64_t id = 0;
        Action action = Action::Change;
        relief::Scenario scenario;
        QString what;
        QString mergeKey;
        QString path;
        bool whole = false;  // nothing of what is now stays
    };

    void load(Pending pending);
    void finishLoad(const LoadResult& result);
    void accept(const Pending& pending);
    void apply(const relief::Scenario& scenario, bool live);
    void travel(Action action);
    void hideAnswer();
    void takeSnapshot(std::shared_ptr<const Snapshot> snapshot);
    void fail(const RenderFailure& failure);
    void goBack();
    void requestRender(bool live);
    void tellBusy();

    relief::Scenario scenario_;
    std::uint64_t version_ = 0;
    std::uint64_t lastVersion_ = 0;  // versions that turned out impossible are not given again
    bool toLastStep_ = false;        // the ray's last step becomes the chosen one when it is known
    bool raysFromEnd_ = false;
    bool keepStep_ = false;  // what is being changed says which step is the chosen one
    std::shared_ptr<const Snapshot> snapshot_;
    std::shared_ptr<const Snapshot> hidden_;  // the same while somebody guesses
    Layer layer_ = Layer::Color;
    relief::PyramidKind levels_ = relief::PyramidKind::Max;
    std::optional<std::size_t> texel_;
    bool guessing_ = false;
    Style style_;
    History past_;
    History good_;  // as it was for what is shown
    // As it was for what the worker was asked, the latest; older than what is shown: none.
    static constexpr std::size_t kMostAsked = 32;
    std::deque<std::pair<std::uint64_t, History>> asked_;
    std::uint64_t goodVersion_ = 0;
    std::optional<Pending> pending_;
    std::uint64_t lastLoad_ = 0;
    bool waiting_ = false;  // for a full picture of the current version
    bool toldBusy_ = false;
    std::unique_ptr<RenderWorker> worker_;
    BackgroundTasks tasks_{this};
};

}  // namespace reliefui
