// The picture of the 3-D trace in a renderer, for the pane and for files: the relief around the chosen ray, the ray,
// its stretches in the colours of the steps, what the current step knew; a legend below it. It belongs to no window.
#pragma once

#include <memory>
#include <vector>

#include <vtkSmartPointer.h>
#include <QSize>
#include <QString>

#include "panes/step_colors.h"
#include "panes/trace/trace3d_scene.h"
#include "panes/turntable.h"

class vtkActor2D;
class vtkImageData;
class vtkProp;
class vtkRenderWindow;
class vtkRenderer;
class vtkTextActor;

namespace reliefui {

class TracePicture {
  public:
    TracePicture();
    ~TracePicture();
    TracePicture(const TracePicture&) = delete;
    TracePicture& operator=(const TracePicture&) = delete;

    void addTo(vtkRenderWindow* window) const;
    void takeFrom(vtkRenderWindow* window) const;
    vtkRenderer* renderer() const;  // of the relief
    // Null where there is no ray; words say why.
    const TraceScene* scene() const { return scene_.get(); }
    const std::shared_ptr<const Snapshot>& shown() const { return shown_; }

    // Replaces everything. style: in the pixels of the window; exaggeration: of heights.
    // why: what is said where there is no snapshot.
    void show(std::shared_ptr<const Snapshot> snapshot, const Style& style, double exaggeration,
              relief::MessageId why = relief::MessageId::DrawNoPicture);
    void setColors(StepColors colors) { colors_ = colors; }  // of the steps shown next
    void setSize(const QSize& pixels);                       // of the window
    double relief() const { return relief_; }                // how much of its height, from the top, is not the legend
    // The next show() draws anew, whatever it is of.
    void forget();
    void showStep(int step);
    // The camera: the whole patch seen from the side of the ray; the same without turning; the end of the step in the
    // middle. room: how much of the width there is.
    void fit(double room = 1);
    void showAll(double room = 1);
    void follow(int step);
    // Puts the camera, and what depends on it, into the renderer: before each rendering.
    void place();

    Turntable camera;

  private:
    void clear(const Style& style);
    void addRelief();
    void addRay();
    void addStep(const relief::Step& step, std::size_t number);
    void addWords(const QString& words);
    void placeTopLabel();
    void layLegend();
    void paintLegend(const Drawing& drawing, int height);
    StepPaint paint() const;

    vtkSmartPointer<vtkRenderer> renderer_;
    vtkSmartPointer<vtkRenderer> legendRenderer_;
    vtkSmartPointer<vtkActor2D> legendActor_;
    vtkSmartPointer<vtkImageData> legend_;
    QSize size_;
    double relief_ = 1;
    StepColors colors_ = StepColors::Decision;
    std::shared_ptr<const Snapshot> shown_;
    std::unique_ptr<TraceScene> scene_;
    Style style_;
    std::vector<vtkSmartPointer<vtkProp>> stepProps_;  // of the current step, replaced by the next
    vtkSmartPointer<vtkTextActor> topLabel_;           // at the left corner of the slab's top
};

}  // namespace reliefui
