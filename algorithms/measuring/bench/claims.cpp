// The list of claims, and tables of them as text and JSON.
#include "measuring/bench/claims.h"

#include <algorithm>
#include <array>

#include <nlohmann/json.hpp>

#include "relief/errors.h"

namespace relief {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<std::string_view, 3> kVerdicts{"confirmed", "refuted", "depends"};

// Written by `relief claims --measure -o FILE.json` and enclosed in R"json( and )json".
constexpr char kShipped[] =
#include "measuring/bench/claims_shipped.inc"
    ;

std::string verdictText(ClaimVerdict verdict, Language language) {
    constexpr MessageId kWords[] = {MessageId::ClaimConfirmed, MessageId::ClaimRefuted, MessageId::ClaimDepends};
    return sentence(Message(kWords[static_cast<std::size_t>(verdict)]), language);
}

}  // namespace

const std::vector<Claim>& paperClaims() {
    using M = MessageId;
    constexpr std::string_view kMip = "[MIP18]";
    constexpr std::string_view kDist = "[DIST17]";
    constexpr std::string_view kPersp = "[PERSP]";
    constexpr std::string_view kTex = "[TEX]";
    const Message abstract(M::PlaceAbstract);
    const Message introduction(M::PlaceIntroduction);
    const Message results(M::PlaceResults);
    const Message relevance(M::PlaceRelevance);
    const Message solution(M::PlaceSolution);
    const Message derivatives(M::PlaceDerivatives);
    const Message weights(M::PlaceWeights);
    const auto formula = [](const char* n) { return Message(M::PlaceFormula, {{"n", n}}); };
    const auto figure = [](const char* n) { return Message(M::PlaceFigure, {{"n", n}}); };
    static const std::vector<Claim> claims{
        {"many-cases", kMip, abstract, M::ClaimManyCases, M::ClaimManyCasesFound},
        {"diagonal", kMip, introduction, M::ClaimDiagonal, M::ClaimDiagonalFound},
        {"no-refinement", kMip, introduction, M::ClaimNoRefinement, M::ClaimNoRefinementFound},
        {"gain-by-relief", kMip, introduction, M::ClaimGainByRelief, M::ClaimGainByReliefFound},
        {"no-loss", kMip, introduction, M::ClaimNoLoss, M::ClaimNoLossFound},
        {"highest", kMip, results, M::ClaimHighest, M::ClaimHighestFound},
        {"two-a-level", kMip, results, M::ClaimTwoALevel, M::ClaimTwoALevelFound},
        {"excludes", kMip, figure("6"), M::ClaimExcludes, M::ClaimExcludesFound},
        {"experiment", kMip, results, M::ClaimExperiment, M::ClaimExperimentFound},
        {"bricks-best", kMip, results, M::ClaimBricksBest, M::ClaimBricksBestFound},
        {"hybrid", kMip, results, M::ClaimHybrid, M::ClaimHybridFound},
        {"offset", kDist, figure("1"), M::ClaimOffset, M::ClaimOffsetFound},
        {"few-layers", kDist, figure("2"), M::ClaimFewLayers, M::ClaimFewLayersFound},
        {"layers-grazing", kDist, figure("2"), M::ClaimLayersGrazing, M::ClaimLayersGrazingFound},
        {"never-crosses", kDist, figure("4"), M::ClaimNeverCrosses, M::ClaimNeverCrossesFound},
        {"donnelly-exact", kDist, relevance, M::ClaimDonnellyExact, M::ClaimDonnellyExactFound},
        {"donnelly-complex", kDist, relevance, M::ClaimDonnellyComplex, M::ClaimDonnellyComplexFound},
        {"many-near", kDist, relevance, M::ClaimManyNear, M::ClaimManyNearFound},
        {"example", kDist, figure("8"), M::ClaimExample, M::ClaimExampleFound},
        {"refined-fewer", kDist, abstract, M::ClaimRefinedFewer, M::ClaimRefinedFewerFound},
        {"refined-exact", kDist, abstract, M::ClaimRefinedExact, M::ClaimRefinedExactFound},
        {"unchanged", kDist, solution, M::ClaimUnchanged, M::ClaimUnchangedFound},
        {"affine", kPersp, introduction, M::ClaimAffine, M::ClaimAffineFound},
        {"direct-counts", kPersp, formula("2"), M::ClaimDirectCounts, M::ClaimCountsFound},
        {"row-constant", kPersp, formula("3"), M::ClaimRowConstant, M::ClaimCountsFound},
        {"incremental", kPersp, formula("4"), M::ClaimIncremental, M::ClaimCountsFound},
        {"streams", kPersp, formula("5"), M::ClaimStreams, M::ClaimStreamsFound},
        {"derivative-counts", kTex, derivatives, M::ClaimDerivativeCounts, M::ClaimDerivativeCountsFound},
        {"iterative", kTex, derivatives, M::ClaimIterative, M::ClaimIterativeFound},
        {"cached", kTex, derivatives, M::ClaimCached, M::ClaimCachedFound},
        {"trilinear", kTex, figure("2"), M::ClaimTrilinear, M::ClaimFiltersFound},
        {"gaussian", kTex, weights, M::ClaimGaussian, M::ClaimFiltersFound},
        {"weight-maps", kTex, weights, M::ClaimWeightMaps, M::ClaimWeightMapsFound},
        {"hidden", kTex, figure("4"), M::ClaimHidden, M::ClaimHiddenFound},
    };
    return claims;
}

const ClaimsTable& shippedClaims() {
    static const ClaimsTable table = parseClaims(kShipped, "claims_shipped.inc");
    return table;
}

std::string claimsText(const ClaimsTable& table, Language language) {
    std::string text = sentence(Message(MessageId::ClaimMachine, {{"date", table.date},
                                                                  {"cpu", table.cpu},
                                                                  {"compiler", table.compiler},
                                                                  {"commit", table.commit},
                                                                  {"size", table.size},
                                                                  {"rays", table.rays}}),
                                language) +
                       "\n" + sentence(Message(MessageId::ClaimHeading), language) + "\n";
    for (const Claim& claim : paperClaims()) {
        const auto measured = std::find_if(table.claims.begin(), table.claims.end(),
                                           [&](const MeasuredClaim& one) { return one.id == claim.id; });
        const bool known = measured != table.claims.end();
        text += std::string(claim.paper) + ", " + sentence(claim.place, language) + " | " +
                sentence(Message(claim.sentence), language) + " | " +
                (known ? sentence(Message(claim.found, measured->values), language) + " | " +
                             verdictText(measured->verdict, language)
                       : sentence(Message(MessageId::ClaimNotMeasured), language) + " |") +
                "\n";
    }
    return text;
}

std::string claimsJson(const ClaimsTable& table) {
    Json json{{"date", table.date},     {"cpu", table.cpu},   {"compiler", table.compiler},
              {"commit", table.commit}, {"size", table.size}, {"rays", table.rays}};
    json["claims"] = Json::array();
    for (const MeasuredClaim& claim : table.claims) {
        Json values = Json::object();
        for (const MessageValue& value : claim.values) values[value.name] = value.text;
        json["claims"].push_back({{"id", claim.id},
                                  {"verdict", kVerdicts[static_cast<std::size_t>(claim.verdict)]},
                                  {"values", std::move(values)}});
    }
    return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

ClaimsTable parseClaims(const std::string& text, const std::string& fileName) {
    try {
        const Json json = Json::parse(text);
        ClaimsTable table;
        table.date = json.at("date").get<std::string>();
        table.cpu = json.at("cpu").get<std::string>();
        table.compiler = json.at("compiler").get<std::string>();
        table.commit = json.at("commit").get<std::string>();
        table.size = json.at("size").get<int>();
        table.rays = json.at("rays").get<std::int64_t>();
        for (const Json& one : json.at("claims")) {
            MeasuredClaim claim;
            claim.id = one.at("id").get<std::string>();
            const auto verdict = std::find(kVerdicts.begin(), kVerdicts.end(), one.at("verdict").get<std::string>());
            if (verdict == kVerdicts.end()) throw InputError(fileName, Message(MessageId::BenchNotTable));
            claim.verdict = static_cast<ClaimVerdict>(verdict - kVerdicts.begin());
            for (const auto& [name, value] : one.at("values").items()) {
                claim.values.emplace_back(name, value.get<std::string>());
            }
            table.claims.push_back(std::move(claim));
        }
        return table;
    } catch (const Json::exception&) {
        throw InputError(fileName, Message(MessageId::BenchNotTable));
    }
}

}  // namespace relief
