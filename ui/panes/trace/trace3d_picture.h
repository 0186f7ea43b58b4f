// The 3-D trace in a VTK renderer, for the pane and for files: the relief around the chosen ray, the ray, its parts
// coloured by step, the data of the current step; a legend below. It is independent of any window.
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

// Label of a step: its number and the value it read.
QString stepWords(const relief::Step& step, std::size_t number);
inline constexpr double kTraceLegendMargin = 6;  // in points
inline constexpr double kMostTraceLegend = 0.3;  // of the height; a higher legend is left out

class TracePicture {
  public:
    TracePicture();
    ~TracePicture();
    TracePicture(const TracePicture&) = delete;
    TracePicture& operator=(const TracePicture&) = delete;

    void addTo(vtkRenderWindow* window) const;
    void takeFrom(vtkRenderWindow* window) const;
    vtkRenderer* renderer() const;  // renderer of the relief
    // Null if there is no ray; a message explains why.
    const TraceScene* scene() const { return scene_.get(); }
    const std::shared_ptr<const Snapshot>& shown() const { return shown_; }

    // Replaces the whole content. style: in the window's pixels; exaggeration: factor of the heights. why: message
    // shown without a snapshot.
    void show(std::shared_ptr<const Snapshot> snapshot, const Style& style, double exaggeration,
              relief::MessageId why = relief::MessageId::DrawNoPicture);
    void setColors(StepColors colors) { colors_ = colors; }  // applies to the steps shown next
    void setSize(const QSize& pixels);                       // of the window
    // share of the height, from the top, not used by the legend
    double relief() const { return relief_; }
    // Makes the next show() rebuild everything, even for the same snapshot.
    void forget();
    void showStep(int step);
    // Camera: fit() shows the whole patch from the side of the ray; showAll() does so without rotating; follow()
    // centres the end of the step. room: usable share of the width.
    void fit(double room = 1);
    void showAll(double room = 1);
    void follow(int step);
    // Applies the camera, and everything that depends on it, to the renderer; call it before each rendering.
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
    std::vector<vtkSmartPointer<vtkProp>> stepProps_;  // of the current step; replaced by the next
    vtkSmartPointer<vtkTextActor> topLabel_;           // at the left corner of the slab's top
};

}  // namespace reliefui
