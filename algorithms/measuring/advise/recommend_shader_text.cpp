// The advice for shaders as text and as JSON.
#include "measuring/advise/advice_json.h"
#include "measuring/advise/recommend_shader.h"
#include "measuring/bench/machine.h"
#include "measuring/text_table.h"

namespace relief {

namespace {

constexpr int kDigits = 3;

std::string number(double value) {
    return std::isnan(value) ? "-" : readable(value, kDigits);
}

std::string sizeText(const AdvisedTexture& texture) {
    std::string text = std::to_string(texture.width) + " x " + std::to_string(texture.height);
    return texture.depth > 1 ? text + " x " + std::to_string(texture.depth) : text;
}

// "R16, RG16".
std::string formatsText(const ShaderForm& form) {
    std::vector<std::string> formats;
    for (const AdvisedTexture& one : form.textures) formats.push_back(one.format);
    return commaList(formats);
}

class ShaderSentences {
  public:
    ShaderSentences(const ShaderAdviceOptions& options, const ShaderAdvice& advice, Language language)
        : options_(options), advice_(advice), language_(language) {}

    std::string text() {
        const HeightField& field = options_.field;
        say(MessageId::ShaderAdviceAsked, {{"relief", options_.name},
                                           {"width", field.width()},
                                           {"height", field.height()},
                                           {"address", std::string(addressName(field.address()))},
                                           {"depth", field.reliefDepth()},
                                           {"views", viewsText(options_.views)}});
        say(MessageId::ShaderAdviceLimits,
            {limit("steps", options_.maxSteps),
             limit("fetches", options_.maxFetches),
             {"memory", bytesText(options_.memory, kDigits)},
             options_.error ? MessageValue("error", *options_.error) : limit("error", 0)});
        text_ += '\n';
        if (advice_.best().measured()) {
            if (!advice_.keepsLimits) say(MessageId::ShaderAdviceNothing, {});
            technique();
        } else {
            say(MessageId::ShaderAdviceUnmeasured, {});
        }
        table(MessageId::ShaderAdviceTable, true);
        table(MessageId::ShaderAdvicePast, false);
        return text_;
    }

  private:
    static MessageValue limit(const char* name, std::int64_t value) {
        return value > 0 ? MessageValue(name, value) : MessageValue(name, MessageId::ShaderAdviceNoLimit);
    }

    void say(MessageId id, std::vector<MessageValue> values) {
        text_ += sentence(Message(id, std::move(values)), language_) + "\n";
    }

    void technique() {
        const ShaderForm& best = advice_.best();
        say(MessageId::ShaderAdviceTechnique, {{"method", methodText(best.method)}});
        for (const AdvisedTexture& one : best.textures) {
            say(MessageId::ShaderAdviceTexture, {{"format", one.format},
                                                 {"size", sizeText(one)},
                                                 {"levels", one.levels},
                                                 {"holds", one.holds},
                                                 {"bytes", bytesText(one.bytes(), kDigits)}});
        }
        const Message which = best.bounded ? Message(MessageId::ShaderAdviceAnyRay)
                                           : Message(MessageId::ShaderAdviceMeasuredRays, {{"rays", advice_.rays}});
        say(MessageId::ShaderAdviceCounts, {{"steps", number(best.stepsMean)},
                                            {"fetches", number(best.fetchesMean)},
                                            {"kind", std::string(fetchKindName(best.fetchKind))},
                                            {"stepsP99", number(best.stepsP99)},
                                            {"fetchesP99", number(best.fetchesP99)},
                                            {"mostSteps", best.mostSteps},
                                            {"mostFetches", best.mostFetches},
                                            {"which", which}});
        say(MessageId::ShaderAdviceError, {{"flip", number(best.flip)},
                                           {"worst", number(best.flipWorst)},
                                           {"pictures", advice_.pictures},
                                           {"width", options_.width},
                                           {"height", options_.height},
                                           {"shift", number(best.shiftP99)},
                                           {"displaced", number(best.displaced * 100)},
                                           {"guarantee", std::string(guaranteeName(best.guarantee))}});
        text_ += '\n';
        say(MessageId::ShaderAdviceCommands, {});
        for (const std::string& command : best.commands) text_ += "  " + command + "\n";
    }

    // One line for each technique and texture: the form that would be chosen if there were no other techniques.
    void table(MessageId heading, bool kept) {
        std::vector<TableRow> rows{{"", "FLIP", "worst", "shift", "off %", "steps", "most", "fetches", "most",
                                    "textures", "memory", "verdict", "filter"}};
        for (const std::size_t f : shaderRows(options_, advice_)) {
            const ShaderForm& form = advice_.forms[f];
            if ((form.verdict == Verdict::Kept) != kept) continue;
            const auto most = [](std::int64_t count) { return count > 0 ? std::to_string(count) : "-"; };
            rows.push_back({methodText(form.method), number(form.flip), number(form.flipWorst), number(form.shiftP99),
                            number(form.displaced * 100), number(form.stepsMean), most(form.mostSteps),
                            number(form.fetchesMean), most(form.mostFetches), formatsText(form),
                            sentence(bytesText(form.bytes(), kDigits)), std::string(verdictName(form.verdict)),
                            std::string(fetchKindName(form.fetchKind))});
        }
        if (rows.size() == 1) return;
        text_ += '\n';
        say(heading, {});
        constexpr std::size_t kVerdict = 11;
        text_ += textTable(rows, 1, kVerdict);
    }

    const ShaderAdviceOptions& options_;
    const ShaderAdvice& advice_;
    Language language_;
    std::string text_;
};

using Json = nlohmann::ordered_json;

Json formJson(const ShaderForm& form) {
    Json textures = Json::array();
    for (const AdvisedTexture& one : form.textures) {
        textures.push_back({{"format", one.format},
                            {"holds", sentence(Message(one.holds))},
                            {"width", one.width},
                            {"height", one.height},
                            {"depth", one.depth},
                            {"mip_levels", one.levels},
                            {"bytes", one.bytes()}});
    }
    return {{"method", form.method.name},
            {"options", optionsText(form.method, false)},
            {"text", methodText(form.method)},
            {"verdict", std::string(verdictName(form.verdict))},
            {"guarantee", std::string(guaranteeName(form.guarantee))},
            {"flip", form.flip},
            {"flip_worst", form.flipWorst},
            {"shift_p99", form.shiftP99},
            {"displaced", form.displaced},
            {"steps", form.stepsMean},
            {"steps_p99", form.stepsP99},
            {"steps_max", form.mostSteps},
            {"fetches", form.fetchesMean},
            {"fetches_p99", form.fetchesP99},
            {"fetches_max", form.mostFetches},
            {"max_of_any_ray", form.bounded},
            {"fetch_filter", std::string(fetchKindName(form.fetchKind))},
            {"textures", textures},
            {"memory_bytes", form.bytes()},
            {"build_seconds", form.buildSeconds},
            {"commands", form.commands}};
}

}  // namespace

std::string shaderAdviceText(const ShaderAdviceOptions& options, const ShaderAdvice& advice, Language language) {
    return ShaderSentences(options, advice, language).text();
}

std::string shaderAdviceJson(const ShaderAdviceOptions& options, const ShaderAdvice& advice) {
    Json json = adviceSubject(options.name, options.field, options.views);
    json.update({{"form", "shader"},
                 {"max_steps", options.maxSteps},
                 {"max_fetches", options.maxFetches},
                 {"memory_limit_bytes", options.memory},
                 {"error", options.error ? Json(*options.error) : Json(nullptr)},
                 {"seconds", options.seconds},
                 {"seed", options.seed},
                 {"pictures", advice.pictures},
                 {"picture_size", std::to_string(options.width) + "x" + std::to_string(options.height)},
                 {"rays", advice.rays},
                 {"keeps_bounds", advice.keepsLimits},
                 {"chosen", advice.best().measured() ? formJson(advice.best()) : Json(nullptr)}});
    json["forms"] = Json::array();
    for (const ShaderForm& form : advice.forms) json["forms"].push_back(formJson(form));
    json["commit"] = commitText();
    return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace relief
