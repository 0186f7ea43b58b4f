#include <cmath>

#include "measuring/diagnose/diagnose.h"

namespace relief {

namespace {

constexpr int kDigits = 3;

struct FaultText {
    MessageId cause;
    MessageId cure;
    MessageId detail;
};

FaultText textOf(Fault fault) {
    using enum MessageId;
    switch (fault) {
        case Fault::MissedSpike:
            return {CauseMissedSpike, CureMissedSpike, DetailLayers};
        case Fault::StairSteps:
            return {CauseStairSteps, CureStairSteps, DetailLayers};
        case Fault::NoRefinement:
            return {CauseNoRefinement, CureNoRefinement, DetailLayers};
        case Fault::UnsafeMap:
            return {CauseUnsafeMap, CureUnsafeMap, DetailNone};
        case Fault::SwappedAxes:
            return {CauseSwappedAxes, CureSwappedAxes, DetailNone};
        case Fault::DirectionSign:
            return {CauseDirectionSign, CureDirectionSign, DetailNone};
        case Fault::InvertedHeights:
            return {CauseInvertedHeights, CureInvertedHeights, DetailNone};
        case Fault::ZeroLevel:
            return {CauseZeroLevel, CureZeroLevel, DetailHeights};
        case Fault::ReliefDepth:
            return {CauseReliefDepth, CureReliefDepth, DetailFactor};
        case Fault::HalfTexelShift:
            return {CauseHalfTexelShift, CureHalfTexelShift, DetailNone};
        case Fault::YFlipped:
            return {CauseYFlipped, CureYFlipped, DetailNone};
        case Fault::WrapAgainstClamp:
            return {CauseWrapAgainstClamp, CureWrapAgainstClamp, DetailNone};
        case Fault::Terraces:
            return {CauseTerraces, CureTerraces, DetailNone};
        case Fault::MipLevel:
            return {CauseMipLevel, CureMipLevel, DetailLevel};
        case Fault::OffsetLimiting:
            return {CauseOffsetLimiting, CureOffsetLimiting, DetailNone};
        case Fault::TangentFrame:
            return {CauseTangentFrame, CureTangentFrame, DetailDegrees};
        case Fault::StepLimit:
            return {CauseStepLimit, CureStepLimit, DetailNone};
        case Fault::SelfShadowBias:
            return {CauseSelfShadowBias, CureSelfShadowBias, DetailNone};
        case Fault::HeightCurve:
            return {CauseHeightCurve, CureHeightCurve, DetailNone};
        case Fault::NoSearch:
            break;
    }
    return {CauseNoSearch, CureNoSearch, DetailNone};
}

std::string percentText(std::size_t count, std::size_t of) {
    return numberText(100.0 * static_cast<double>(count) / static_cast<double>(of), kDigits);
}

Message errorText(double texels) {
    if (std::isinf(texels)) return Message(MessageId::DiagnosisOutcome);
    return Message(MessageId::DiagnosisTexels, {{"texels", numberText(texels, kDigits)}});
}

}  // namespace

Message faultCause(Fault fault) {
    return Message(textOf(fault).cause);
}
Message faultCure(Fault fault) {
    return Message(textOf(fault).cure);
}

std::vector<Message> diagnosisLines(const Diagnosis& diagnosis, const RayNames& names) {
    std::vector<Message> lines;
    if (diagnosis.healthy()) {
        lines.push_back(Message(MessageId::DiagnosisHealthy, {{"wrong", diagnosis.wrong},
                                                              {"rays", diagnosis.rays},
                                                              {"texels", numberText(kRightTexels)},
                                                              {"touching", diagnosis.touching}}));
        return lines;
    }
    for (const Finding& finding : diagnosis.findings) {
        const Fault fault = finding.fault.fault;
        const MessageId detail = finding.fault.value == 0 ? MessageId::DetailNone : textOf(fault).detail;
        lines.push_back(Message(MessageId::DiagnosisLine,
                                {{"name", std::string(faultName(fault))},
                                 {"percent", percentText(finding.rays, diagnosis.rays)},
                                 {"detail", Message(detail, {{"value", numberText(finding.fault.value, kDigits)}})},
                                 {"cause", faultCause(fault)},
                                 {"cure", faultCure(fault)},
                                 {"worst", names(finding.worst)},
                                 {"error", errorText(finding.texels)}}));
    }
    if (diagnosis.unknown()) {
        lines.push_back(
            Message(MessageId::DiagnosisUnknown, {{"percent", percentText(diagnosis.unexplained, diagnosis.rays)},
                                                  {"worst", names(diagnosis.worst)},
                                                  {"error", errorText(diagnosis.errors[diagnosis.worst])}}));
    }
    return lines;
}

}  // namespace relief
