// The window's one model: the open scenario, the chosen pixel, ray and step, undo as a history of scenario values, and
// the render worker. Views look at it and ask it for changes; they never talk to each other.
//
// Everything that computes runs on the worker's thread; the latest request wins. Results carry the version of the
// scenario they were made from, and arrive together, so that panes never mix two states.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include <QImage>
#include <QObject>
#include <QString>

#include "images/pyramid.h"
#include "relief/maps/max_pyramid_map.h"
#include "relief/tracers.h"
#include "rendering/frame.h"
#include "scenario/scenario.h"

namespace reliefui {

// The chosen pixel's ray as the production tracer logged it.
struct PixelTrace {
    relief::PixelChoice pixel;
    bool onRelief = false;  // false: no polygon covers the pixel; the rest is empty then
    relief::ViewRay ray;
    relief::Hit hit;
    std::vector<relief::Step> steps;
    std::uint32_t reads = 0;
};

// One state of everything on screen. Immutable, shared.
struct Snapshot {
    std::uint64_t version = 0;  // of the scenario
    relief::Scenario scenario;
    relief::Assets assets;
    std::shared_ptr<const relief::FrameRequest> request;
    bool coarse = false;                          // drawn at a fraction of the size while something is dragged
    std::shared_ptr<const relief::Frame> frame;   // of the coarse size, if coarse
    QImage picture;                               // the frame as shown; its size is the frame's
    PixelTrace trace;                             // in full-size pixels, also when coarse
    std::shared_ptr<const relief::MaxPyramidMap> maxima;   // over the cells of the field
    std::shared_ptr<const relief::Pyramid> means;          // over the texels
};

class RenderWorker;

class Workspace : public QObject {
    Q_OBJECT
  public:
    explicit Workspace(QObject* parent = nullptr);
    ~Workspace() override;

    const relief::Scenario& scenario() const { return scenario_; }
    std::uint64_t version() const { return version_; }
    // The newest complete state; null before the first.
    std::shared_ptr<const Snapshot> snapshot() const { return snapshot_; }

    // A new scenario value. Changes with the same non-empty mergeKey in a row (a drag) become one step of undo. While
    // `live`, a coarse picture is drawn first. An impossible value is refused with problem() and changes nothing.
    void change(const relief::Scenario& scenario, const QString& what, const QString& mergeKey = {},
                bool live = false);
    // Ends a run of merged changes (mouse released): the full picture is drawn.
    void settle();
    // Chooses a pixel (clamped to the picture) or a step of its ray. Part of the undo history as well.
    void choosePixel(int x, int y);
    void chooseStep(int step);

    bool canUndo() const;
    bool canRedo() const;
    QString undoText() const;
    QString redoText() const;

    // Opens a picture (height map) or a scenario file (.json). On an error: problem(), everything as it was.
    void open(const QString& path);
    void save(const QString& path);
    QString traceCommand() const;  // the `relief trace` line of the chosen pixel
    bool busy() const;

  public slots:
    void undo();
    void redo();
    void cancel();

  signals:
    void scenarioChanged();                                  // at once, before anything is computed
    void snapshotChanged();                                  // a new state is on screen
    void stepChanged(int step);                              // only the chosen step changed
    void progress(const QString& what, double fraction);     // fraction < 0: done
    void problem(const QString& oneLine);                    // to be shown; nothing changed

  private:
    struct Past;
    relief::Scenario scenario_;
    std::uint64_t version_ = 0;
    std::shared_ptr<const Snapshot> snapshot_;
    std::unique_ptr<Past> past_;
    std::unique_ptr<RenderWorker> worker_;
};

}  // namespace reliefui
