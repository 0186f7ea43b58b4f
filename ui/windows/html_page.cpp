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

constexpr double kPageMm = 105;  // width for which figures are drawn: text is as large as the page's
constexpr int kJpegQuality = 82;
constexpr int kPictureWidth = 720;                // of frames and figures that are pictures, pixels
constexpr std::size_t kMostVectorBytes = 150000;  // of one frame; larger ones, mostly pixels, become pictures
constexpr int kStepMs = 900, kFrameMs = 120;      // time of a frame while playing

void replaceAll(std::string& text, const std::string& from, const std::string& to) {
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
        text.replace(at, from.size(), to);
    }
}

// Returns a group of the file without what browsers take for granted.
std::string shortened(std::string group) {
    replaceAll(group, "\n", " ");
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
    group.erase(std::unique(group.begin(), group.end(), [](char x, char y) { return x == ' ' && y == ' '; }),
                group.end());
    replaceAll(group, " >", ">");
    replaceAll(group, "> <", "><");
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

std::string jpegData(const QImage& picture) {
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    picture.convertToFormat(QImage::Format_RGB32).save(&buffer, "JPEG", kJpegQuality);
    return "data:image/jpeg;base64," + bytes.toBase64().toStdString();
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

// All frames of a figure, in one language.
struct Frames {
    int width = 1, height = 1;            // of the tallest
    std::vector<std::vector<int>> parts;  // per frame
    std::vector<std::string> words;       // below it

    void fit(int w, int h) {
        width = w;
        height = std::max(height, h);
    }
    void fit(const std::string& svg) {
        static const std::regex kBox("viewBox=\"0 0 ([0-9]+) ([0-9]+)\"");
        std::smatch sides;
        const std::string head = svg.substr(0, svg.find("<g "));
        if (std::regex_search(head, sides, kBox)) fit(std::stoi(sides[1]), std::stoi(sides[2]));
    }
};
using FramesInBoth = std::map<relief::Language, Frames>;

std::string sentenceOf(const Snapshot& snapshot, int step, relief::Language language) {
    const PixelTrace& trace = snapshot.trace;
    if (static_cast<std::size_t>(step) >= trace.steps.size()) return {};
    return relief::sentence(relief::stepSentence(trace.steps, static_cast<std::size_t>(step), trace.ray, trace.exact),
                            language);
}

Frames steppedFrames(const FigureKind& kind, const std::shared_ptr<const Snapshot>& snapshot,
                     const std::vector<int>& steps, relief::Language language, HtmlParts& parts, relief::Work& work) {
    const QTemporaryDir folder;
    Frames frames;
    for (const int step : steps) {
        relief::Scenario scenario = snapshot->scenario;
        scenario.step = step;
        auto stepped = std::make_shared<Snapshot>(*snapshot);
        stepped->scenario.step = step;
        const std::string svg = svgOf(*kind.make(stepped, scenario), pageIn(language), folder, work);
        frames.fit(svg);
        frames.parts.push_back(parts.add(svg));
        frames.words.push_back(sentenceOf(*snapshot, step, language));
    }
    return frames;
}

bool allEqual(const std::vector<std::vector<int>>& frames) {
    return std::adjacent_find(frames.begin(), frames.end(), std::not_equal_to<>()) == frames.end();
}

// How frames are shown. slider: its name for screen readers; ms: time of a frame while playing; pixels: the frames are
// pictures, which keep their colours on a dark page.
struct Showing {
    const char* slider;
    int ms;
    bool pixels;
};

// Returns the <figure>. values: the text of the slider at each frame; shown: the frame without scripts.
std::string framesHtml(const std::string& name, const FramesInBoth& frames, const std::vector<std::string>& values,
                       std::size_t shown, HtmlParts& parts, const Showing& how) {
    const Frames& english = frames.at(relief::Language::English);
    const Frames& ukrainian = frames.at(relief::Language::Ukrainian);
    const bool moves = values.size() > 1 && !allEqual(english.parts);
    nlohmann::json data{{"steps", values}, {"ms", how.ms}};
    std::string html = "<figure class=\"steps\">\n";
    for (const auto& [language, drawn] : frames) {
        const std::string code = languageCode(language);
        html += "<svg class=\"" + code + (how.pixels ? " pixels" : "") + "\" viewBox=\"0 0 " +
                std::to_string(drawn.width) + " " + std::to_string(drawn.height) + "\" role=\"img\" aria-label=\"" +
                relief::escapedHtml(name) + "\">";
        for (const int part : drawn.parts[shown]) html += parts.part(part);
        html += "</svg>\n";
        data[code] = drawn.parts;
        data["say-" + code] = drawn.words;
    }
    if (!moves) return html + "</figure>\n";
    for (const auto& [language, drawn] : frames) {
        // The script finds the parts of the shown frame in the drawing.
        const std::set<int> there(drawn.parts[shown].begin(), drawn.parts[shown].end());
        for (std::vector<int> others : drawn.parts) {
            std::erase_if(others, [&](int part) { return there.contains(part); });
            parts.setNeeded(others);
        }
    }
    html +=
        "<div class=\"slider\"><button type=\"button\" class=\"play\" aria-label=\"play\">▶</button>"
        "<input type=\"range\" min=\"0\" max=\"" +
        std::to_string(values.size() - 1) + "\" value=\"" + std::to_string(shown) + "\" aria-label=\"" + how.slider +
        "\"><output>" + relief::escapedHtml(values[shown]) + "</output></div>\n<figcaption>" +
        inBoth(relief::escapedHtml(english.words[shown]), relief::escapedHtml(ukrainian.words[shown])) +
        "</figcaption>\n";
    std::string json = data.dump();
    replaceAll(json, "</", "<\\/");
    return html + "<script type=\"application/json\" class=\"frames\">" + json + "</script>\n</figure>\n";
}

// Returns the size of all different parts of the frames.
std::size_t bytesOf(const FramesInBoth& frames, const HtmlParts& parts) {
    std::set<int> different;
    for (const auto& [language, drawn] : frames) {
        for (const std::vector<int>& frame : drawn.parts) different.insert(frame.begin(), frame.end());
    }
    std::size_t bytes = 0;
    for (const int part : different) bytes += parts.part(part).size();
    return bytes;
}

// Returns for how many steps there should be room: two steps tell how many bytes a step has of its own.
std::size_t mostSteps(const FigureKind& kind, const std::shared_ptr<const Snapshot>& snapshot, HtmlParts& parts,
                      const LanguageSetter& installLanguage, relief::Work& work) {
    const int last = std::max(static_cast<int>(snapshot->trace.steps.size()) - 1, 0);
    const int chosen = snapshot->scenario.step;
    installLanguage(relief::Language::English);
    const std::size_t before = parts.bytes();
    const Frames one = steppedFrames(kind, snapshot, {chosen}, relief::Language::English, parts, work);
    const std::size_t oneBytes = parts.bytes() - before;
    const Frames other =
        steppedFrames(kind, snapshot, {chosen == last ? 0 : last}, relief::Language::English, parts, work);
    if (one.parts == other.parts) return 1;
    const std::size_t each = std::max<std::size_t>(parts.bytes() - before - oneBytes, 1);
    return std::min(kMostPageSteps, (kMostFigureBytes - std::min(kMostFigureBytes, oneBytes)) / (2 * each));
}

// Makes a figure and computes what the page needs.
std::shared_ptr<const Figure> readyFigure(const FrameMaker& make, const FigurePage& page, relief::Work& work) {
    auto figure = make();
    auto prepared = figure->prepared(page, work);
    return prepared ? prepared : figure;
}

// A figure that is pixels: as drawn for the chosen step.
std::string pixelsFigure(const FigureKind& kind, const std::shared_ptr<const Snapshot>& snapshot, relief::Work& work) {
    const auto figure = kind.make(snapshot, snapshot->scenario);
    return "<figure>" +
           pictureHtml(figureImage(*figure, pageIn(relief::Language::English), kPictureWidth, work), kind.name) +
           "</figure>\n";
}

}  // namespace

bool followsSteps(const FigureKind& kind) {
    constexpr std::array<std::string_view, 9> kNames{"profile", "duel",  "distance",    "pyramid", "steps",
                                                     "slabs",   "trace", "formula-ray", "formula"};
    return std::find(kNames.begin(), kNames.end(), kind.name) != kNames.end();
}

// The relief of the 3-D trace would be thousands of polygons for each step.
bool hasStepDrawings(const FigureKind& kind) {
    return kind.vectors && kind.name != TracePane::kName;
}

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
    for (std::string& group : groupsOf(svg)) numbers.push_back(addPart(std::move(group)));
    return numbers;
}

int HtmlParts::add(const QImage& picture) {
    return addPart("<image width=\"" + std::to_string(picture.width()) + "\" height=\"" +
                   std::to_string(picture.height()) + "\" href=\"" + jpegData(picture) + "\"/>");
}

int HtmlParts::addPart(std::string part) {
    const auto [found, isNew] = numbers_.try_emplace(part, static_cast<int>(parts_.size()));
    if (isNew) {
        bytes_ += part.size();
        parts_.push_back(std::move(part));
    }
    return found->second;
}

void HtmlParts::setNeeded(const std::vector<int>& numbers) {
    needed_.insert(numbers.begin(), numbers.end());
}

std::string HtmlParts::script() const {
    nlohmann::json needed = nlohmann::json::array();
    for (std::size_t n = 0; n < parts_.size(); ++n) {
        if (needed_.contains(static_cast<int>(n))) {
            needed.push_back(parts_[n]);
        } else {
            needed.push_back(0);
        }
    }
    std::string json = needed.dump();
    replaceAll(json, "</", "<\\/");
    return "<script type=\"application/json\" id=\"parts\">" + json + "</script>\n";
}

std::string stepsFigure(const FigureKind& kind, const std::shared_ptr<const Snapshot>& snapshot, HtmlParts& parts,
                        const LanguageSetter& installLanguage, relief::Work& work) {
    if (!hasStepDrawings(kind)) return pixelsFigure(kind, snapshot, work);
    std::size_t most = followsSteps(kind) ? mostSteps(kind, snapshot, parts, installLanguage, work) : 1;
    std::vector<int> steps;
    FramesInBoth frames;
    for (;; most /= 2) {
        steps = stepsOf(*snapshot, most);
        for (const relief::Language language : kPageLanguages) {
            installLanguage(language);
            frames[language] = steppedFrames(kind, snapshot, steps, language, parts, work);
        }
        // Other steps may have more of their own.
        if (most < 4 || bytesOf(frames, parts) <= kMostFigureBytes) break;
    }
    const auto chosen =
        static_cast<std::size_t>(std::find(steps.begin(), steps.end(), snapshot->scenario.step) - steps.begin());
    std::vector<std::string> values;
    for (const int step : steps) values.push_back(std::to_string(step + 1));
    return framesHtml(kind.name, frames, values, std::min(chosen, steps.size() - 1), parts, {"step", kStepMs, false});
}

std::string framesFigure(const FigureKind& kind, const FrameSource& source, HtmlParts& parts,
                         const LanguageSetter& installLanguage, relief::Work& work) {
    const QTemporaryDir folder;
    FramesInBoth frames;
    std::vector<std::string> values;
    bool pixels = !kind.vectors;
    source([&](const FrameMaker& make, const std::string& value, const std::string& changed) {
        for (const relief::Language language : kPageLanguages) {
            installLanguage(language);
            Frames& drawn = frames[language];
            FigurePage page = pageIn(language);
            if (pixels) page.widthPixels = kPictureWidth;
            auto figure = readyFigure(make, page, work);
            const std::string svg = pixels ? std::string() : svgOf(*figure, page, folder, work);
            if (frames.size() == 1 && drawn.parts.empty() && svg.size() > kMostVectorBytes) {
                pixels = true;
                page.widthPixels = kPictureWidth;
                figure = readyFigure(make, page, work);
            }
            if (pixels) {
                const QImage picture = figureImage(*figure, page, kPictureWidth, work);
                drawn.fit(picture.width(), picture.height());
                drawn.parts.push_back({parts.add(picture)});
            } else {
                drawn.fit(svg);
                drawn.parts.push_back(parts.add(svg));
            }
            const std::string caption = figure->caption(language);
            drawn.words.push_back(changed.empty() ? caption : changed + " · " + caption);
        }
        values.push_back(value);
    });
    return framesHtml(kind.name, frames, values, 0, parts, {"frame", kFrameMs, pixels});
}

std::string pictureHtml(const QImage& picture, const std::string& alt) {
    return "<img alt=\"" + relief::escapedHtml(alt) + "\" width=\"" + std::to_string(picture.width()) + "\" height=\"" +
           std::to_string(picture.height()) + "\" src=\"" + jpegData(picture) + "\">";
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
