// The pictures of one view that a comparison sets beside each other, how far they are from a reference, and how fast
// they are made.
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

// Rays of a view that rates are measured on, at most: enough for a median that differs by less than its spread, few
// enough for a second.
inline constexpr std::size_t kComparedRays = 8192;

struct ComparedPicture {
    relief::MethodChoice choice;  // of the comparison's subject
    std::string name;             // "A max-pyramid"
    // What the picture depends on, itself in the place of the scenario's own.
    relief::Scenario shows;
    std::optional<relief::Message> problem;      // why there is no frame
    std::shared_ptr<const relief::Frame> frame;  // the snapshot's own of A
    std::shared_ptr<const relief::Tracer> tracer;
    QImage picture;
    // Of full frames only. The maps of errors, in the colours of their scale.
    std::optional<relief::PictureError> error;
    bool equal = false;  // the picture has the reference's bits
    std::shared_ptr<const relief::FloatImage> l1, flip;
    QImage l1Picture, flipPicture;
    bool traces = true;           // a method of the kind of tracers; of other subjects, whether rates are measured
    std::optional<double> rate;   // methods: 10^6 rays a second; filters: 10^6 pixels a second
    std::optional<double> steps;  // records a ray

    const QImage& shown(const relief::Comparison& how, bool reference) const;
};

// How errors become colours: those of all pictures but the reference together.
struct ErrorScale {
    ColorRange range;
    ColorScale scale;
    std::shared_ptr<const ValueSpread> spread;  // null: nothing is measured
};
RangeOf rangeOf(relief::CompareMeasure measure);

struct ComparedView {
    relief::Scenario scenario;  // pixel and step are those of the time when it was made
    bool coarse = false;
    std::shared_ptr<const relief::Frame> frame;  // the snapshot's
    std::vector<ComparedPicture> pictures;
    std::string reference;             // its name
    relief::Scenario against;          // what the reference depends on
    bool complete = false;             // all pictures are this scenario's, and measured unless they are coarse
    std::array<ErrorScale, 2> scales;  // by the measure
    std::size_t rays = 0;              // that rates were measured on, or pixels
    int rounds = 0;
    bool rated = false;  // or there are no rates

    const ErrorScale& scaleOf(relief::CompareMeasure measure) const {
        return scales[static_cast<std::size_t>(measure)];
    }
    // Whether errors are shown in these ranges.
    bool inRanges(const ColorRanges& ranges) const;
    bool isReference(const ComparedPicture& picture) const;
    // Whether it shows what this snapshot wants compared.
    bool of(const Snapshot& snapshot) const;
    // Whether a picture is the one that this scenario wants in its place, and whether its numbers are.
    bool current(const relief::Scenario& scenario, std::size_t number) const;
    bool measured(const relief::Scenario& scenario, std::size_t number) const;
};

// What the pictures are measured against, and its name.
relief::MethodChoice comparedReference(const relief::Scenario& scenario);
std::string comparedReferenceName(const relief::Scenario& scenario);
std::string comparedName(std::size_t number, relief::CompareSubject subject, const relief::MethodChoice& choice);

// Renders what is compared; keeps the buffers of each picture, so that only what changed is rendered again. Used by one
// thread at a time.
class Comparer {
  public:
    using Listener = std::function<void(std::shared_ptr<const ComparedView>)>;

    // What cannot be rendered (another surface) gets a `problem`. before: shown until now; its pictures keep their
    // places until theirs are made. made: told of the view after each of its pictures. Throws Cancelled.
    std::shared_ptr<const ComparedView> view(const Snapshot& snapshot, const ComparedView* before, const Listener& made,
                                             relief::Work& work);

  private:
    struct Rendered {
        std::unique_ptr<relief::FrameRenderer> renderer;
        std::shared_ptr<const relief::Frame> frame;
        std::shared_ptr<const relief::FloatImage> read, heights;  // as read, as varied
        QImage picture;
        int used = 0;  // in which call
    };
    Rendered& rendered(const Snapshot& snapshot, const relief::MethodChoice& choice, relief::Work& work);
    void fill(ComparedPicture& picture, const Snapshot& snapshot, relief::Work& work);
    void measure(ComparedView& view, const relief::Frame& reference, relief::Work& work) const;

    std::map<std::string, Rendered> rendered_;
    int calls_ = 0;
};

// The same with the errors in the colours of these ranges; of a view that was measured.
std::shared_ptr<const ComparedView> recolored(const ComparedView& view, const ColorRanges& ranges);

// The pictures that the view shows as the snapshot's scenario compares them, rendered anew `width` pixels wide; errors
// in the colours of the view's scale. Null images where a picture has a problem. Throws Cancelled, MemoryError.
std::vector<QImage> redrawnPictures(const ComparedView& view, const Snapshot& snapshot, int width, relief::Work& work);

// The same with rates: rays of the view traced by all methods in turn, with their steps; pixels of it by all filters.
// Throws Cancelled.
std::shared_ptr<const ComparedView> withRates(const ComparedView& view, const Snapshot& snapshot, relief::Work& work);

// What is said of a picture that is being made, and whether the one in its place, of what was compared before, is
// veiled.
struct ComparePending {
    relief::Message text{relief::MessageId::DrawComparePending};
    bool veil = false;
    bool stopped = false;  // it is not being made
};
// As this scenario wants it: of pictures and numbers that are another one's it says that they are pending. shown: of
// flicker.
CompareSource compareSource(const ComparedView& view, const relief::Scenario& scenario, std::size_t shown,
                            const ComparePending& pending = ComparePending());

// What a picture has at a pixel of the full-size picture, in a line: "B layers: hit (12.1, 4.0), 20 steps, FLIP 0.3".
QString compareReadout(const ComparedView& view, const relief::Scenario& scenario, std::size_t number,
                       relief::PixelChoice pixel);

}  // namespace reliefui
