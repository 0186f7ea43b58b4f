#include "panes/doctor/doctor_data.h"

#include <algorithm>
#include <cmath>

#include "measuring/diagnose/error_picture.h"
#include "painting/picture_values.h"

namespace reliefui {

namespace {

using relief::Message;
using relief::MessageId;

// Sets the picture, and for each of its places the ray with the largest error.
void draw(DoctorReport& report, const relief::HeightField& field) {
    const std::vector<float>& errors = report.diagnosis.errors;
    const auto& view = report.view;
    report.picture =
        pictureValues(view ? relief::errorPicture(view->scenario.width, view->scenario.height, view->pixels, errors)
                           : relief::errorPicture(field, report.rays, errors));
    report.rayAt = relief::Image<int>(report.picture->width(), report.picture->height(), -1);
    for (std::size_t r = 0; r < errors.size(); ++r) {
        const relief::PixelChoice at = view ? view->pixels[r] : relief::entryTexel(field, report.rays[r]);
        report.places.push_back(at);
        int& there = report.rayAt(at.x, at.y);
        if (there < 0 || errors[r] > errors[static_cast<std::size_t>(there)]) there = static_cast<int>(r);
    }
}

}  // namespace

DoctorSubject::DoctorSubject(const Snapshot& snapshot)
    : scenario(snapshot.scenario), files(snapshot.otherFiles), heights(snapshot.request->field.identity()) {}

bool DoctorSubject::of(const Snapshot& snapshot) const {
    const relief::Scenario& now = snapshot.scenario;
    return files == snapshot.otherFiles && heights == snapshot.request->field.identity() &&
           scenario.address == now.address && scenario.surface == now.surface &&
           scenario.reliefDepth == now.reliefDepth;
}

Message DoctorReport::nameOf(std::size_t ray) const {
    if (!view) return Message(MessageId::DiagnosisRay, {{"ray", ray}});
    return Message(MessageId::DiagnosisPixel, {{"ray", ray}, {"x", view->pixels[ray].x}, {"y", view->pixels[ray].y}});
}

std::shared_ptr<const DoctorReport> doctorReport(const Snapshot& snapshot, relief::Work& work) {
    const relief::HeightField& field = snapshot.request->field;
    auto report = std::make_shared<DoctorReport>(snapshot);
    const relief::OtherTracer& other = snapshot.scenario.other;
    const relief::TracerRecord record = relief::tracerRecord(*snapshot.otherFiles, field, other.steps);
    work.throwIfStopped();
    if (snapshot.otherFiles->viewProblem) throw *snapshot.otherFiles->viewProblem;
    report->view = snapshot.otherFiles->view;
    report->diagnosis = relief::diagnose(record, field, work);
    report->rays = record.rays;
    const relief::Diagnosis& found = report->diagnosis;
    report->lines = relief::diagnosisLines(found, [&](std::size_t ray) { return report->nameOf(ray); });
    if (found.healthy()) {
        report->worst.emplace_back();
    } else {
        for (const relief::Finding& finding : found.findings) report->worst.emplace_back(finding.worst);
        if (found.unknown()) report->worst.emplace_back(found.worst);
    }
    draw(*report, field);
    return report;
}

Message doctorReadout(const DoctorReport& report, std::size_t ray) {
    const auto error = static_cast<double>(report.diagnosis.errors[ray]);
    const Message off = std::isinf(error)
                            ? Message(MessageId::DiagnosisOutcome)
                            : Message(MessageId::DiagnosisTexels, {{"texels", relief::numberText(error, 3)}});
    return Message(MessageId::DoctorReadout, {{"ray", report.nameOf(ray)}, {"error", off}});
}

}  // namespace reliefui
