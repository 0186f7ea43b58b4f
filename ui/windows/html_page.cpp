#include "windows/html_page.h"

#include <algorithm>
#include <filesystem>
#include <regex>

#include <QBuffer>
#include <QTemporaryDir>

#include <nlohmann/json.hpp>

#include "measuring/lesson/lesson_text.h"
#include "panes/trace/trace_state.h"
#include "relief/files.h"
#include "scenario/step_sentence.h"

// The style and the script of pages; their texts are resources of the sources, not of the user.
#include "windows/html_style.inc"
#include "windows/program.h"

namespace reliefui {

namespace {

constexpr double kPageMm = 105;         // width for which figures are drawn: text is as large as the page's
constexpr std::size_t kMostSteps = 40;  // of a slider
constexpr int kJpegQuality = 82;

void replaceAll(std::string& text, const std::string& from, const std::string& to) {
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
        text.replace(at, from.size(), to);
    }
}

// Returns a group of the file without what browsers take for granted.
std::string shortened(std::string group) {
    for (const char* const usual : {" vector-effect=\"none\"", " stroke-opacity=\"1\"", " fill-opacity=\"1\"",
                                    " transform=\"matrix(1,0,0,1,0,0)\"", " fill-rule=\"evenodd\"",
                                    " font-style=\"normal\"", " font-weight=\"400\"", " font-family=\"DejaVu Sans\""}) {
        replaceAll(group, usual, "");
    }
    replaceAll(group, "xlink:href", "href");
    if (group.find("<text") == std::string::npos) {
        static const std::regex kSize(" ?font-size=\"[^\"]*\"");
        // Only in the group's own tag: a picture's data are long.
        const std::size_t end = group.find('>');
        group = std::regex_replace(group.substr(0, end), kSize, "") + group.substr(end);
    }
    group.erase(
        std::unique(group.begin(), group.end(), [](char a, char b) { return a == b && (a == '\n' || a == ' '); }),
        group.end());
    return group;
}

// The groups of a drawing that Qt wrote, without empty ones.
std::vector<std::string> groupsOf(const std::string& svg) {
    std::vector<std::string> groups;
    // Everything is in one outer group, whose defaults the page's style sheet repeats.
    std::size_t at = svg.find("<g ");
    if (at == std::string::npos) return groups;
    at = svg.find("<g ", at + 1);
    while (at != std::string::npos) {
        const std::size_t end = svg.find("</g>", at);
        if (end == std::string::npos) break;
        const std::string group = svg.substr(at, end + 4 - at);
        const std::size_t open = group.find('>');
        if (group.find('<', open) < group.size() - 4) groups.push_back(shortened(group));
        at = svg.find("<g ", end);
    }
    return groups;
}

std::string viewBoxOf(const std::string& svg) {
    const std::size_t at = svg.find("viewBox=\"");
    if (at == std::string::npos) return "0 0 1 1";
    const std::size_t begin = at + 9;
    return svg.substr(begin, svg.find('"', begin) - begin);
}

std::string svgOf(const Figure& figure, const FigurePage& page, const QTemporaryDir& folder, relief::Work& work) {
    const std::string path = folder.filePath(QStringLiteral("figure.svg")).toStdString();
    writeFigure(figure, page, path, work);
    return relief::readTextFile(path);
}

FigurePage pageIn(relief::Language language) {
    FigurePage page;
    page.widthMm = kPageMm;
    page.dpi = 110;  // of pictures in drawings
    page.caption = false;
    page.style.theme = Theme::Light;
    page.style.language = language;
    return page;
}

// The steps of a slider: all of a short ray; of a long one evenly chosen ones, and the chosen step.
std::vector<int> stepsOf(const Snapshot& snapshot, std::size_t most) {
    const std::size_t all = snapshot.trace.steps.size();
    const int chosen = snapshot.scenario.step;
    if (all == 0) return {chosen};
    std::vector<int> steps;
    const std::size_t count = std::min(all, std::max<std::size_t>(most, 1));
    for (std::size_t n = 0; n < count; ++n) {
        steps.push_back(static_cast<int>(count == 1 ? static_cast<std::size_t>(chosen) : n * (all - 1) / (count - 1)));
    }
    if (std::find(steps.begin(), steps.end(), chosen) == steps.end()) steps.push_back(chosen);
    std::sort(steps.begin(), steps.end());
    steps.erase(std::unique(steps.begin(), steps.end()), steps.end());
    return steps;
}

// A figure at all of its steps, in one language.
struct Frames {
    std::string viewBox;
    std::vector<std::vector<int>> parts;  // per step
};

Frames framesOf(const FigureKind& kind, const std::shared_ptr<const Snapshot>& snapshot, const std::vector<int>& steps,
                relief::Language language, HtmlParts& parts, relief::Work& work) {
    const QTemporaryDir folder;
    Frames frames;
    for (const int step : steps) {
        relief::Scenario scenario = snapshot->scenario;
        scenario.step = step;
        auto stepped = std::make_shared<Snapshot>(*snapshot);
        stepped->scenario.step = step;
        const std::string svg = svgOf(*kind.make(stepped, scenario), pageIn(language), folder, work);
        if (frames.viewBox.empty()) frames.viewBox = viewBoxOf(svg);
        frames.parts.push_back(parts.add(svg));
    }
    return frames;
}

std::string sentenceOf(const Snapshot& snapshot, int step, relief::Language language) {
    const PixelTrace& trace = snapshot.trace;
    if (static_cast<std::size_t>(step) >= trace.steps.size()) return {};
    return relief::sentence(relief::stepSentence(trace.steps, static_cast<std::size_t>(step), trace.ray, trace.exact),
                            language);
}

bool allEqual(const std::vector<std::vector<int>>& frames) {
    return std::adjacent_find(frames.begin(), frames.end(), std::not_equal_to<>()) == frames.end();
}

// The figures that show the chosen step. Others may take seconds to draw, and are drawn once.
bool followsSteps(const FigureKind& kind) {
    constexpr std::array<std::string_view, 8> kNames{"profile", "duel",  "distance",    "pyramid",
                                                     "steps",   "slabs", "formula-ray", "formula"};
    return std::find(kNames.begin(), kNames.end(), kind.name) != kNames.end();
}

// Returns how many steps there is room for: two steps tell how many bytes a step has of its own.
std::size_t mostSteps(const FigureKind& kind, const std::shared_ptr<const Snapshot>& snapshot, HtmlParts& parts,
                      const LanguageSetter& installLanguage, relief::Work& work) {
    const int last = std::max(static_cast<int>(snapshot->trace.steps.size()) - 1, 0);
    const int chosen = snapshot->scenario.step;
    installLanguage(relief::Language::English);
    const std::size_t before = parts.bytes();
    const Frames one = framesOf(kind, snapshot, {chosen}, relief::Language::English, parts, work);
    const std::size_t oneBytes = parts.bytes() - before;
    const Frames other = framesOf(kind, snapshot, {chosen == last ? 0 : last}, relief::Language::English, parts, work);
    if (one.parts == other.parts) return 1;
    const std::size_t each = std::max<std::size_t>(parts.bytes() - before - oneBytes, 1);
    return std::min(kMostSteps, (kMostFigureBytes - std::min(kMostFigureBytes, oneBytes)) / (2 * each));
}

// A figure that is pixels: as drawn for the chosen step.
std::string pixelsFigure(const FigureKind& kind, const std::shared_ptr<const Snapshot>& snapshot, relief::Work& work) {
    constexpr int kWidth = 720;
    const auto figure = kind.make(snapshot, snapshot->scenario);
    return "<figure>" + pictureHtml(figureImage(*figure, pageIn(relief::Language::English), kWidth, work), kind.name) +
           "</figure>\n";
}

}  // namespace

const char* languageCode(relief::Language language) {
    return language == relief::Language::Ukrainian ? "uk" : "en";
}

void installPageLanguage(relief::Language language) {
    installTranslations(QLatin1String(languageCode(language)));
}

void checkHtmlFile(const std::string& path) {
    const std::string ending = std::filesystem::path(path).extension().string();
    if (ending == ".html") return;
    throw relief::InputError(
        path, relief::Message(relief::MessageId::FormatUnknown, {{"extension", ending}, {"known", "html"}}));
}

std::string inBoth(const std::string& english, const std::string& ukrainian) {
    return "<span class=\"en\" lang=\"en\">" + english + "</span><span class=\"uk\" lang=\"uk\">" + ukrainian +
           "</span>";
}

std::vector<int> HtmlParts::add(const std::string& svg) {
    std::vector<int> numbers;
    for (std::string& group : groupsOf(svg)) {
        const auto [found, isNew] = numbers_.try_emplace(group, static_cast<int>(parts_.size()));
        if (isNew) {
            bytes_ += group.size();
            parts_.push_back(std::move(group));
        }
        numbers.push_back(found->second);
    }
    return numbers;
}

std::string HtmlParts::script() const {
    std::string json = nlohmann::json(parts_).dump();
    replaceAll(json, "</", "<\\/");
    return "<script type=\"application/json\" id=\"parts\">" + json + "</script>\n";
}

std::string stepsFigure(const FigureKind& kind, const std::shared_ptr<const Snapshot>& snapshot, HtmlParts& parts,
                        const LanguageSetter& installLanguage, relief::Work& work) {
    // The relief of the 3-D trace would be thousands of polygons for each step.
    if (!kind.vectors || kind.name == TracePane::kName) return pixelsFigure(kind, snapshot, work);
    const std::size_t most = followsSteps(kind) ? mostSteps(kind, snapshot, parts, installLanguage, work) : 1;
    const std::vector<int> steps = stepsOf(*snapshot, most);
    std::map<relief::Language, Frames> frames;
    for (const relief::Language language : kPageLanguages) {
        installLanguage(language);
        frames[language] = framesOf(kind, snapshot, steps, language, parts, work);
    }
    const auto chosen =
        static_cast<std::size_t>(std::find(steps.begin(), steps.end(), snapshot->scenario.step) - steps.begin());
    const std::size_t shown = chosen < steps.size() ? chosen : steps.size() - 1;
    const bool moves = steps.size() > 1 && !allEqual(frames[relief::Language::English].parts);
    nlohmann::json data;
    std::string html = "<figure class=\"steps\">\n";
    for (const relief::Language language : kPageLanguages) {
        const Frames& drawn = frames[language];
        html += std::string("<svg class=\"") + languageCode(language) + "\" viewBox=\"" + drawn.viewBox +
                "\" role=\"img\" aria-label=\"" + relief::escapedHtml(kind.name) + "\">";
        for (const int part : drawn.parts[shown]) html += parts.part(part);
        html += "</svg>\n";
        if (!moves) continue;
        data[languageCode(language)] = drawn.parts;
        for (const int step : steps)
            data[std::string("say-") + languageCode(language)].push_back(sentenceOf(*snapshot, step, language));
    }
    if (moves) {
        for (const int step : steps) data["steps"].push_back(step + 1);
        html += "<div class=\"slider\"><input type=\"range\" min=\"0\" max=\"" + std::to_string(steps.size() - 1) +
                "\" value=\"" + std::to_string(shown) + "\" aria-label=\"step\"><output>" +
                std::to_string(steps[shown] + 1) + "</output></div>\n<figcaption>" +
                inBoth(relief::escapedHtml(sentenceOf(*snapshot, steps[shown], relief::Language::English)),
                       relief::escapedHtml(sentenceOf(*snapshot, steps[shown], relief::Language::Ukrainian))) +
                "</figcaption>\n";
        std::string json = data.dump();
        replaceAll(json, "</", "<\\/");
        html += "<script type=\"application/json\" class=\"frames\">" + json + "</script>\n";
    }
    return html + "</figure>\n";
}

std::string pictureHtml(const QImage& picture, const std::string& alt) {
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    picture.convertToFormat(QImage::Format_RGB32).save(&buffer, "JPEG", kJpegQuality);
    return "<img alt=\"" + relief::escapedHtml(alt) + "\" width=\"" + std::to_string(picture.width()) + "\" height=\"" +
           std::to_string(picture.height()) + "\" src=\"data:image/jpeg;base64," + bytes.toBase64().toStdString() +
           "\">";
}

std::string wholePage(const std::string& english, const std::string& ukrainian, const std::string& body,
                      const HtmlParts& parts) {
    return "<!DOCTYPE html>\n<html lang=\"en\" data-title-en=\"" + relief::escapedHtml(english) +
           "\" data-title-uk=\"" + relief::escapedHtml(ukrainian) +
           "\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" content=\"width=device-width, "
           "initial-scale=1\">\n"
           "<meta name=\"generator\" content=\"Reliefscope\">\n<link rel=\"icon\" href=\"data:,\">\n<title>" +
           relief::escapedHtml(english) + "</title>\n<style>" + kPageStyle + "</style>\n</head>\n<body>\n" +
           "<input type=\"radio\" name=\"language\" id=\"show-en\" checked><label for=\"show-en\">English</label>\n"
           "<input type=\"radio\" name=\"language\" id=\"show-uk\"><label "
           "for=\"show-uk\">Українська</label>\n<main>\n" +
           body + "</main>\n" + parts.script() + "<script>" + kPageScript + "</script>\n</body>\n</html>\n";
}

}  // namespace reliefui
