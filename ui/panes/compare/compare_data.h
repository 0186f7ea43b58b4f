// The pictures of a comparison of one view, their errors against a reference, and the speed at which they are made.
#pragma once

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <QImage>

#include "measuring/compare/picture_error.h"
#include "panes/compare/compare_drawing.h"
#include "scenario/variation.h"
#include "workspace/snapshot.h"

namespace reliefui {

// Largest number of rays used to measure rates: enough for a median whose error is below the spread, few enough to
// measure in about a second.
inline constexpr std::size_t kComparedRays = 8192;

struct ComparedPicture {
    relief::MethodChoice choice;  // method, filter, mapping or heights, depending on the subject
    std::string name;             // "A max-pyramid"
    // Scenario on which the picture depends, with `choice` in place of the scenario's own.
    relief::Scenario shows;
    std::optional<relief::Message> problem;      // explains why there is no frame
    std::shared_ptr<const relief::Frame> frame;  // for A, the snapshot's own
    std::shared_ptr<const relief::Tracer> tracer;
    QImage picture;
    // Only for full frames: errors, and maps of errors in the colours of their scale.
    std::optional<relief::PictureError> error;
    bool equal = false;  // bitwise equal to the reference
    std::shared_ptr<const relief::FloatImage> l1, flip;
    QImage l1Picture, flipPicture;
    bool traces = true;           // rates can be measured; for methods: it is a tracer
    std::optional<double> rate;   // methods: 10^6 rays per second; filters: 10^6 pixels per second
    double spread = 0;            // of the rate: interquartile range of the rounds, relative to the rate
    std::optional<double> steps;  // mean number of logged steps per ray

    const QImage& shown(const relief::Comparison& how, bool reference) const;
};

// Mapping of errors to colours, common to all pictures except the reference.
struct ErrorScale {
    ColorRange range;
    ColorScale scale;
    std::shared_ptr<const ValueSpread> spread;  // null: not measured
};
RangeOf rangeOf(relief::CompareMeasure measure);

struct ComparedView {
    relief::Scenario scenario;  // pixel and step as they were when the view was made
    bool coarse = false;
    std::shared_ptr<const relief::Frame> frame;  // the snapshot's
    std::vector<ComparedPicture> pictures;
    std::string reference;             // name of the reference
    relief::Scenario against;          // scenario on which the reference depends
    bool complete = false;             // all pictures belong to this scenario, and are measured unless coarse
    std::array<ErrorScale, 2> scales;  // indexed by the measure
    std::size_t rays = 0;              // number of rays or pixels used to measure rates
    int rounds = 0;
    bool rated = false;  // rates are measured, or none are needed

    const ErrorScale& scaleOf(relief::CompareMeasure measure) const {
        return scales[static_cast<std::size_t>(measure)];
    }
    // Returns true if the errors are shown in these ranges.
    bool inRanges(const ColorRanges& ranges) const;
    bool isReference(const ComparedPicture& picture) const;
    // Returns true if the view is the comparison that the snapshot's scenario specifies.
    bool of(const Snapshot& snapshot) const;
    // Return true if this picture, or its numbers, are those that the scenario specifies.
    bool current(const relief::Scenario& scenario, std::size_t number) const;
    bool measured(const relief::Scenario& scenario, std::size_t number) const;
};

// The reference of the comparison, and its name.
relief::MethodChoice comparedReference(const relief::Scenario& scenario);
std::string comparedReferenceName(const relief::Scenario& scenario);
std::string comparedName(std::size_t number, relief::CompareSubject subject, const relief::MethodChoice& choice);

// Renders comparisons. Buffers of each picture are kept, so that only what changed is rendered again. May be used by
// one thread at a time.
class Comparer {
  public:
    using Listener = std::function<void(std::shared_ptr<const ComparedView>)>;

    // Renders all pictures. A choice that cannot be rendered, for instance because it does not support the surface,
    // gets a `problem`. before: the view shown until now, whose pictures stay until they are replaced; may be null.
    // made: called with the view after each picture. Throws Cancelled.
    std::shared_ptr<const ComparedView> view(const Snapshot& snapshot, const ComparedView* before, const Listener& made,
                                             relief::Work& work);

  private:
    struct Rendered {
        std::unique_ptr<relief::FrameRenderer> renderer;
        std::shared_ptr<const relief::Frame> frame;
        std::shared_ptr<const relief::FloatImage> read, heights;  // as read from the file, as varied
        QImage picture;
        int used = 0;  // number of the call that last used it
    };
    Rendered& rendered(const Snapshot& snapshot, const relief::MethodChoice& choice, relief::Work& work);
    void fill(ComparedPicture& picture, const Snapshot& snapshot, relief::Work& work);
    void measure(ComparedView& view, const relief::Frame& reference, relief::Work& work) const;

    std::map<std::string, Rendered> rendered_;
    int calls_ = 0;
};

// Returns a copy of a measured view with the errors recoloured in these ranges.
std::shared_ptr<const ComparedView> recolored(const ComparedView& view, const ColorRanges& ranges);

// Renders the pictures of the view again, `width` pixels wide, as compared in the snapshot's scenario; errors use the
// colours of the view's scale. The images of pictures with a problem are null. Throws Cancelled, MemoryError.
std::vector<QImage> redrawnPictures(const ComparedView& view, const Snapshot& snapshot, int width, relief::Work& work);

// Returns a copy of the view with rates: all methods trace rays of the view in turn, or all filters filter pixels of
// it. Throws Cancelled.
std::shared_ptr<const ComparedView> withRates(const ComparedView& view, const Snapshot& snapshot, relief::Work& work);

// State of pictures in progress: the message shown for them, and whether the outdated picture in their place is veiled.
struct ComparePending {
    relief::Message text{relief::MessageId::DrawComparePending};
    bool veil = false;
    bool stopped = false;  // it was cancelled
};
// Prepares the view for drawing, as this scenario specifies it: pictures and numbers that belong to another scenario
// are reported as pending. shown: index of the picture in flicker mode.
CompareSource compareSource(const ComparedView& view, const relief::Scenario& scenario, std::size_t shown,
                            const ComparePending& pending = ComparePending());

// Values of a picture at a pixel of the full-size picture, in one line: "B layers: hit (12.1, 4.0), 20 steps, FLIP
// 0.3".
QString compareReadout(const ComparedView& view, const relief::Scenario& scenario, std::size_t number,
                       relief::PixelChoice pixel);

}  // namespace reliefui
