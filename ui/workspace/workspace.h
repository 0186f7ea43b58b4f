// The window's only model: the open scenario, the chosen pixel, ray and step, the undo history of scenario values, and
// the render worker. Views observe it and request changes; they never communicate with each other.
//
// All computation runs on the worker's thread; the latest request wins. Results carry the version of the scenario they
// were made from and arrive as a whole, so that panes never mix two states. Pictures are loaded before they become part
// of the scenario. If a change later proves impossible, the scenario returns to the last state that was shown, so that
// window and scenario always agree.
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
    // readers: check the panes' states in scenarios; null: states are accepted unchecked.
    explicit Workspace(std::shared_ptr<const StateReaders> readers = nullptr, QObject* parent = nullptr);
    ~Workspace() override;

    // Opens the first scenario and starts the worker. `store`: pictures that are already loaded.
    void start(const relief::Scenario& scenario, relief::AssetStore store = {});

    const relief::Scenario& scenario() const { return scenario_; }
    std::uint64_t version() const { return version_; }
    // The newest complete state; null before the first one.
    std::shared_ptr<const Snapshot> snapshot() const { return guessing_ && hidden_ ? hidden_ : snapshot_; }

    // Changes the scenario. Consecutive changes with the same non-empty mergeKey, such as a drag, form one step of
    // undo. While `live`, a coarse picture is drawn first. An invalid value is refused with problem() and changes
    // nothing.
    void change(const relief::Scenario& scenario, const QString& what, const QString& mergeKey = {}, bool live = false);
    // Ends a series of merged changes (mouse released), and draws the full picture.
    void finishInteraction();
    // Chooses a pixel (clamped to the picture) and the first step of its ray, or a step. Both are part of the undo
    // history.
    void choosePixel(int x, int y);
    void chooseStep(int step);
    // Choose the last step instead, for each pixel. Not part of the scenario.
    bool raysFromEnd() const { return raysFromEnd_; }
    void setRaysFromEnd(bool on) { raysFromEnd_ = on; }

    // Changes breakpoints or bookmarks. They are part of the undo history, but nothing is rendered.
    void setBreakpoints(std::vector<relief::Breakpoint> breakpoints, const QString& what);
    void setBookmarks(std::vector<relief::Bookmark> bookmarks, const QString& what);
    // Sets camera, pixel and step to those of the bookmark; if its ray has fewer steps, the last one is chosen.
    void goTo(const relief::Bookmark& bookmark);
    // Returns true if goTo() would change nothing.
    bool isAt(const relief::Bookmark& bookmark) const;

    // Index of the texel under the pointer in the footprint's list, so that all panes that show it highlight it;
    // std::nullopt if the pointer is elsewhere. Not part of the scenario; nothing is computed.
    std::optional<std::size_t> texel() const { return texel_; }
    void pointAtTexel(std::optional<std::size_t> texel);

    // While the user guesses where the ray hits, snapshots come without its hit and steps. Not part of the scenario.
    bool guessing() const { return guessing_; }
    void setGuessing(bool on);

    // The layer shown in the result view. Not part of the scenario.
    Layer layer() const { return layer_; }
    void setLayer(Layer layer);
    // The pyramid that is shown; for large pictures only this one is built.
    void setLevels(relief::PyramidKind levels);
    // How panes are drawn (theme, projector, language). Not part of the scenario.
    const Style& style() const { return style_; }
    void setStyle(const Style& style);

    bool canUndo() const { return past_.canUndo(); }
    bool canRedo() const { return past_.canRedo(); }
    QString undoText() const { return canUndo() ? past_.current().what : QString(); }
    QString redoText() const { return canRedo() ? past_.redone().what : QString(); }

    // Opens a picture (height map) or a scenario file (.json). On an error, emits problem() and changes nothing.
    void open(const QString& path);
    // Opens a whole scenario, including its step, as if from a file; `what` is its name in the history.
    void show(const relief::Scenario& scenario, const QString& what);
    void save(const QString& path);
    // Makes the snapshot again, with what another tracer has written into its files since. If they cannot be read,
    // emits problem(), and what was read before stays.
    void renew();
    // Long tasks other than rendering, such as figure export; cancel() cancels them as well.
    BackgroundTasks& tasks() { return tasks_; }
    QString traceCommand() const;  // the `relief trace` command for the chosen pixel
    bool busy() const;
    // Message for panes without a snapshot: it is being computed, or no picture is open.
    relief::MessageId whyEmpty() const {
        return busy() ? relief::MessageId::DrawCompareDrawing : relief::MessageId::DrawNoPicture;
    }
    // Returns true while pictures of a requested scenario are being loaded; scenario() is still the old one.
    bool loading() const { return pending_.has_value(); }

  public slots:
    void undo();
    void redo();
    void cancel();

  signals:
    void scenarioChanged();      // emitted at once, before anything is computed
    void snapshotChanged();      // a new state is on screen
    void stepChanged(int step);  // only the chosen step changed
    void notesChanged();         // only breakpoints or bookmarks changed
    void panesChanged();         // the panes' states changed, possibly by undo or with another scenario
    void texelChanged();         // the pointer is over another texel
    void guessingChanged(bool on);
    void layerChanged();
    void styleChanged();                                  // panes have to be repainted
    void progress(const QString& what, double fraction);  // fraction < 0: finished
    void problem(const QString& oneLine);                 // message for the user; nothing was changed
    void notice(const QString& oneLine);                  // message for the user about what was done to the pictures
    void opened(const QString& path);                     // a file was opened
    void busyChanged(bool busy);

  private:
    const std::shared_ptr<const StateReaders> readers_;
    enum class Action : std::uint8_t { Start, Open, Change, Undo, Redo };
    // A change that waits until its pictures are loaded.
    struct Pending {
        std::uint64_t id = 0;
        Action action = Action::Change;
        relief::Scenario scenario;
        QString what;
        QString mergeKey;
        QString path;
        bool whole = false;  // replaces the whole scenario, not only its pictures
    };

    // The scenario after goTo().
    relief::Scenario at(const relief::Bookmark& bookmark) const;
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
    void reportBusy();

    relief::Scenario scenario_;
    std::uint64_t version_ = 0;
    std::uint64_t lastVersion_ = 0;  // last version number given; numbers of failed changes are not used again
    bool toLastStep_ = false;        // choose the ray's last step as soon as it is known
    bool raysFromEnd_ = false;
    bool keepStep_ = false;  // the change in progress sets the step itself
    std::shared_ptr<const Snapshot> snapshot_;
    std::shared_ptr<const Snapshot> hidden_;  // snapshot_ without the answer, while the user guesses
    Layer layer_ = Layer::Color;
    relief::PyramidKind levels_ = relief::PyramidKind::Max;
    std::optional<std::size_t> texel_;
    bool guessing_ = false;
    Style style_;
    std::uint64_t renewed_ = 0;  // how often renew() was called
    History past_;
    History good_;  // history of the state that is shown
    // Histories of the latest requests to the worker, by version; those older than the state shown are removed.
    static constexpr std::size_t kMostRequested = 32;
    std::deque<std::pair<std::uint64_t, History>> requests_;
    std::uint64_t goodVersion_ = 0;
    std::optional<Pending> pending_;
    std::uint64_t lastLoad_ = 0;
    bool waiting_ = false;  // for a full picture of the current version
    bool reportedBusy_ = false;
    std::unique_ptr<RenderWorker> worker_;
    BackgroundTasks tasks_{this};
};

}  // namespace reliefui
