// The frames of several methods of one view, how far they are from a reference, and how fast they are.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <QImage>

#include "measuring/compare/picture_error.h"
#include "panes/compare/compare_drawing.h"
#include "workspace/snapshot.h"

namespace reliefui {

// Rays of a view that rates are measured on, at most: enough for a median that differs by less than its spread, few
// enough for a second.
inline constexpr std::size_t kComparedRays = 8192;

struct ComparedMethod {
    relief::MethodChoice method;
    std::string name;                            // "A max-pyramid"
    std::optional<relief::Message> problem;      // why there is no frame
    std::shared_ptr<const relief::Frame> frame;  // the snapshot's own of method A
    std::shared_ptr<const relief::Tracer> tracer;
    QImage picture;
    // Of full frames only. The maps of errors, in the colours of their scale.
    std::optional<relief::PictureError> error;
    bool equal = false;  // the picture has the reference's bits
    std::shared_ptr<const relief::FloatImage> l1, flip;
    QImage l1Picture, flipPicture;
    bool traces = true;                 // its kind is that of tracers
    std::optional<double> rate, steps;  // 10^6 rays a second; records a ray

    const QImage& shown(const relief::Comparison& how, bool reference) const;
};

struct ComparedView {
    relief::Scenario scenario;  // pixel and step are those of the time when it was made
    bool coarse = false;
    std::shared_ptr<const relief::Frame> frame;  // the snapshot's
    std::vector<ComparedMethod> methods;
    std::string reference;  // its name
    double l1High = 1;      // of the scales
    double flipHigh = 1;
    std::size_t rays = 0;  // that rates were measured on
    int rounds = 0;

    bool isReference(const ComparedMethod& method) const;
    // Whether it shows what this snapshot wants compared.
    bool of(const Snapshot& snapshot) const;
};

// The methods of a scenario, A first.
std::vector<relief::MethodChoice> comparedMethods(const relief::Scenario& scenario);
std::string comparedName(std::size_t number, const relief::MethodChoice& method);

// Renders what is compared; keeps the buffers of each method, so that only what changed is rendered again. Used by one
// thread at a time.
class Comparer {
  public:
    // Methods that cannot be rendered (another surface) get a `problem`. Throws Cancelled.
    std::shared_ptr<const ComparedView> view(const Snapshot& snapshot, relief::Work& work);

  private:
    struct Rendered {
        std::unique_ptr<relief::FrameRenderer> renderer;
        std::shared_ptr<const relief::Frame> frame;
        QImage picture;
        int used = 0;  // in which call
    };
    Rendered& rendered(const Snapshot& snapshot, const relief::MethodChoice& method, relief::Work& work);
    void measure(ComparedView& view, const relief::Frame& reference, relief::Work& work) const;

    std::map<std::string, Rendered> rendered_;
    int calls_ = 0;
};

// The same with rates and steps: rays of the view traced by all methods in turn. Throws Cancelled.
std::shared_ptr<const ComparedView> withRates(const ComparedView& view, const Snapshot& snapshot, relief::Work& work);

// shown: of flicker.
CompareSource compareSource(const ComparedView& view, const relief::Comparison& how, std::size_t shown);

// What a method answers at a pixel of the full-size picture, in a line: "B layers: hit (12.1, 4.0), 20 steps, FLIP
// 0.3".
QString compareReadout(const ComparedView& view, const Snapshot& snapshot, std::size_t method,
                       relief::PixelChoice pixel);

}  // namespace reliefui
