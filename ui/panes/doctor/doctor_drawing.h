// The picture of the errors of a tracer, and what was found, as a drawing and as a figure.
#pragma once

#include <memory>
#include <optional>

#include "panes/doctor/doctor_data.h"
#include "panes/figure.h"

namespace reliefui {

// chosen: the ray that is marked. Units of the drawing: the picture's pixels.
Drawing doctorPicture(const DoctorReport& report, std::optional<std::size_t> chosen);
// The meaning of the colours; with `lines`, also what was found. width: in points.
Drawing doctorLegend(const DoctorReport& report, bool lines, double width, relief::Language language);
// The ray at a point of the drawing.
std::optional<std::size_t> doctorRayAt(const DoctorReport& report, Point at);

std::shared_ptr<const Figure> doctorFigure(std::shared_ptr<const DoctorReport> report);
// The figure of a snapshot, which is diagnosed first. Throws InputError without files of another tracer.
std::shared_ptr<const Figure> diagnosedFigure(std::shared_ptr<const Snapshot> snapshot, const relief::Scenario&);

}  // namespace reliefui
