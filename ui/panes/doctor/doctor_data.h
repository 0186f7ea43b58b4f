// What is wrong with the tracer whose files are open, and where.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "measuring/diagnose/tracer_files.h"
#include "workspace/snapshot.h"

namespace reliefui {

// What is diagnosed: the files as they were read, and the relief over which their rays run.
struct DoctorSubject {
    relief::Scenario scenario;
    std::shared_ptr<const OtherFiles> files;
    std::shared_ptr<const void> heights;

    explicit DoctorSubject(const Snapshot& snapshot);
    // Returns true if the snapshot shows the same.
    bool of(const Snapshot& snapshot) const;
};

// picture: the errors in the colours of relief::errorColor(), encoded as ColorMap::Picture has them, over the pixels of
// the files' view or, if it is not known, over the map's texels. places: of each ray in the picture. rayAt: number of
// the ray of each pixel or texel, that with the largest error; -1: none. lines: what was found, and the ray of each,
// which has the largest error of its fault; none for the line that says that there is no fault.
struct DoctorReport {
    DoctorSubject subject;
    relief::RayBlock rays;
    std::optional<relief::RaysView> view;
    relief::Diagnosis diagnosis;
    std::shared_ptr<const relief::FloatImage> picture;
    std::vector<relief::PixelChoice> places;
    relief::Image<int> rayAt;
    std::vector<relief::Message> lines;
    std::vector<std::optional<std::size_t>> worst;

    explicit DoctorReport(const Snapshot& snapshot) : subject(snapshot) {}
    relief::Message nameOf(std::size_t ray) const;
};

// snapshot: with files of another tracer. May be called on any thread; takes seconds, with progress. Throws InputError,
// Cancelled.
std::shared_ptr<const DoctorReport> doctorReport(const Snapshot& snapshot, relief::Work& work);

// The error of a ray, in a line.
relief::Message doctorReadout(const DoctorReport& report, std::size_t ray);

}  // namespace reliefui
