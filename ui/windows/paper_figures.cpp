#include "windows/paper_figures.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include <QCryptographicHash>

#include "measuring/lesson/lesson.h"
#include "panes/pdf_date.h"
#include "relief/files.h"
#include "windows/pane_list.h"
#include "workspace/layer_names.h"
#include "workspace/pane_store.h"
#include "workspace/snapshot_maker.h"

namespace reliefui {

namespace fs = std::filesystem;

namespace {

using relief::InputError;
using relief::Json;
using relief::JsonReader;
using relief::Language;
using relief::Message;
using relief::MessageId;
using Texts = PaperFigure::Texts;

constexpr const char* kOption = "--paper-figures";
constexpr std::array<const char*, 3> kEndings{".svg", ".pdf", ".png"};
constexpr int kIndent = 2;  // of JSON files
constexpr std::size_t kMostParts = 8;

// Calls body(index, language) for both languages.
template <class Body>
void inEachLanguage(const Body& body) {
    for (std::size_t n = 0; n < kPageLanguages.size(); ++n) body(n, kPageLanguages[n]);
}

Texts textsOf(JsonReader reader) {
    Texts texts;
    inEachLanguage([&](std::size_t n, Language language) {
        const char* const key = languageCode(language);
        reader.read(key, texts[n]);
        if (texts[n].empty()) reader.fail(key, MessageId::WantAText);
    });
    reader.finish();
    return texts;
}

// Errors in the scenario name the line of its key, because a part's scenario is put together from two places.
relief::Scenario partScenario(const JsonReader& reader, const char* key, const Json& scenario) {
    relief::Scenario parsed;
    reader.guarded({key}, [&] {
        try {
            parsed = parseWindowScenario(scenario.dump(kIndent), key, stateReaders());
        } catch (const InputError& error) {
            throw InputError("", withoutLine(error.message()));
        }
    });
    return parsed;
}

PaperFigure::Part partOf(JsonReader reader, Json scenario, const std::string& folder, const std::string& datasets) {
    PaperFigure::Part part;
    bool known = false;
    reader.named("view", [&](const std::string& name) {
        part.kind = figureKind(name);
        known = static_cast<bool>(part.kind.make);
    });
    if (!known) reader.fail("view", MessageId::WantAView);
    reader.named("layer", [&](const std::string& name) {
        if (!layerNamed(name)) {
            const std::vector<std::string> all(kLayerNames.begin(), kLayerNames.end());
            throw InputError("", relief::unknownName({"what", MessageId::WordLayer}, name, relief::commaList(all)));
        }
        part.layer = name;
    });
    reader.read("width", part.widthMm);
    reader.guarded({"width"}, [&] { requireRange("--width", part.widthMm, kLeastFigureMm, kMostFigureMm); });
    const bool changed = reader.has("change");
    if (changed) {
        if (!reader.object()["change"].is_object()) reader.fail("change", MessageId::WantAObject);
        scenario.merge_patch(reader.object()["change"]);
    }
    relief::resolveShipped(scenario, folder, datasets);
    part.scenario = partScenario(reader, changed ? "change" : "view", scenario);
    reader.finish();
    return part;
}

// Returns the names of the figure's pictures in a language, without the extension.
std::vector<std::string> pictureNames(const PaperFigure& figure, Language language) {
    std::vector<std::string> names;
    for (std::size_t n = 0; n < figure.parts.size(); ++n) {
        std::string name = figure.name;
        if (figure.parts.size() > 1) name += std::string("-") + static_cast<char>('a' + n);
        names.push_back(name + "-" + languageCode(language));
    }
    return names;
}

std::string commandOf(const PaperFigure& figure) {
    std::string command = std::string("reliefscope ") + kOption + " " + figure.name + ".json -o .";
    if (const auto date = sourceDate()) command = "SOURCE_DATE_EPOCH=" + std::to_string(*date) + " " + command;
    return command;
}

// Text in which TeX's special characters stand for themselves, except in formulas: $u_t$.
std::string texText(const std::string& text) {
    const bool formulas = std::count(text.begin(), text.end(), '$') % 2 == 0;
    std::string tex;
    bool formula = false;
    for (const char c : text) {
        if (c == '$' && formulas) formula = !formula;
        if (formula || (c == '$' && formulas)) {
            tex += c;
        } else if (c == '\\') {
            tex += "\\textbackslash{}";
        } else if (c == '^' || c == '~') {
            tex += std::string("\\") + c + "{}";
        } else {
            if (std::string_view("#$%&_{}").find(c) != std::string_view::npos) tex += '\\';
            tex += c;
        }
    }
    return tex;
}

// The letter of a part in the caption.
std::string letterOf(std::size_t part, Language language) {
    static constexpr std::array<const char*, 8> kUkrainian{"а", "б", "в", "г", "д", "е", "ж", "з"};
    if (language == Language::Ukrainian && part < kUkrainian.size()) return kUkrainian[part];
    return {static_cast<char>('a' + part)};
}

std::string texFigure(const PaperFigure& figure, std::size_t n) {
    const Language language = kPageLanguages[n];
    const std::string place = relief::sentence(figure.place(), language);
    std::string tex = "% " + place + (figure.printed.empty() ? "" : ": " + figure.printed) + "\n";
    tex += "% " + commandOf(figure) + "\n";
    // Parts stand next to each other if the line is long enough.
    double total = 0;
    for (const PaperFigure::Part& part : figure.parts) total += part.widthMm;
    constexpr double kColumn = 100;  // mm; wider figures span both columns
    const std::string environment = total > kColumn ? "figure*" : "figure";
    tex += "\\begin{" + environment + "}\n  \\centering\n";
    const std::vector<std::string> names = pictureNames(figure, language);
    for (std::size_t k = 0; k < names.size(); ++k) {
        const std::string width = relief::numberText(figure.parts[k].widthMm) + "mm";
        const std::string picture = "\\includegraphics[width=" + width + "]{" + names[k] + "}";
        if (names.size() == 1) {
            tex += "  " + picture + "\n";
        } else {
            tex += "  \\parbox[t]{" + width + "}{\\centering" + picture + "\\\\(" + letterOf(k, language) + ")}\n";
        }
    }
    const Message after(MessageId::PaperAfter, {{"place", figure.place()}});
    tex += "  \\caption{" + texText(figure.caption[n]) + (figure.note[n].empty() ? "" : " " + texText(figure.note[n])) +
           " " + texText(relief::sentence(after, language)) + "}\n";
    tex += "  \\label{fig:" + figure.name + "}\n\\end{" + environment + "}\n";
    return tex;
}

// A figure without vectors as one that SVG and PDF can hold: its pixels.
std::shared_ptr<const Figure> asPicture(const Figure& figure, const FigurePage& page, relief::Work& work) {
    const QImage image = figureImage(figure, page, page.pixels(), work);
    const double aspect = static_cast<double>(image.height()) / image.width();
    return paintedFigure(
        [image](QPainter& painter, const Box& box, const Style&) {
            painter.drawImage(QRectF(box.x0, box.y0, box.width(), box.height()), image);
        },
        {}, [aspect](const FigurePage&) { return aspect; });
}

std::string checksum(const std::string& file) {
    const std::string bytes = relief::readTextFile(file);
    const QByteArray data = QByteArray::fromRawData(bytes.data(), static_cast<int>(bytes.size()));
    return QCryptographicHash::hash(data, QCryptographicHash::Sha256).toHex().toStdString();
}

bool selected(const std::string& name, const std::string& file) {
    const std::string own = fs::path(file).stem().string();
    return name == "all" || name == own || own.starts_with(name + "-");
}

// "MIP18-4" before "MIP18-10".
bool inOrder(const std::string& a, const std::string& b) {
    const std::string left = a.substr(0, a.rfind('-')), right = b.substr(0, b.rfind('-'));
    return std::tuple(left, a.size(), a) < std::tuple(right, b.size(), b);
}

std::vector<std::string> shippedFiles(const std::string& folder) {
    std::vector<std::string> files;
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(folder, none)) {
        if (entry.path().extension() == ".json") files.push_back(entry.path().string());
    }
    if (files.empty()) throw InputError(kOption, Message(MessageId::PaperFiguresNotFound));
    std::sort(files.begin(), files.end(), inOrder);
    return files;
}

}  // namespace

Message PaperFigure::place() const {
    Message message(page > 0 ? MessageId::PaperPlacePage : MessageId::PaperPlace,
                    {{"paper", paper}, {"number", number}});
    if (page > 0) message.values.push_back({"page", page});
    return message;
}

PaperFigure readPaperFigure(const std::string& file, const std::string& datasets) {
    const std::string text = relief::readTextFile(file);
    PaperFigure figure;
    figure.name = fs::path(file).stem().string();
    figure.json = relief::parseJson(text, file);
    JsonReader reader({text, file}, figure.json, {});
    int version = 0;
    reader.readWhole("paper-figure", version);
    if (version != kPaperFigureVersion) {
        reader.fail("paper-figure", Message(MessageId::PaperVersion, {{"known", kPaperFigureVersion}}));
    }
    reader.read("paper", figure.paper);
    if (figure.paper.empty()) reader.fail("paper", MessageId::WantAText);
    reader.readWhole("number", figure.number);
    if (figure.number < 1) reader.fail("number", MessageId::WantALarger);
    reader.readWhole("page", figure.page);
    if (figure.page < 0) reader.fail("page", MessageId::WantALarger);
    reader.read("printed", figure.printed);
    figure.caption = textsOf(reader.child("caption"));
    if (reader.has("note")) figure.note = textsOf(reader.child("note"));
    const Json scenario = reader.has("scenario") ? figure.json["scenario"] : Json::object();
    if (!scenario.is_object()) reader.fail("scenario", MessageId::WantAObject);
    reader.readObjects("parts", [&](JsonReader part) {
        figure.parts.push_back(partOf(std::move(part), scenario, fs::path(file).parent_path().string(), datasets));
    });
    if (figure.parts.empty() || figure.parts.size() > kMostParts) {
        reader.fail("parts", Message(MessageId::RangeOf, {{"low", 1}, {"high", kMostParts}}));
    }
    // What writePaperFigure() adds; it is written anew.
    for (const char* const added : {"command", "program", "files"}) {
        if (reader.has(added)) figure.json.erase(added);
    }
    reader.finish();
    return figure;
}

std::vector<std::string> paperFigureFiles(const std::string& names, const std::string& folder) {
    std::vector<std::string> files;
    std::size_t begin = 0;
    for (std::size_t end = 0; end < names.size(); begin = end + 1) {
        end = std::min(names.find(',', begin), names.size());
        const std::string name = names.substr(begin, end - begin);
        if (fs::path(name).extension() == ".json") {
            files.push_back(name);
            continue;
        }
        const std::vector<std::string> shipped = shippedFiles(folder);
        const std::size_t before = files.size();
        std::copy_if(shipped.begin(), shipped.end(), std::back_inserter(files),
                     [&](const std::string& file) { return selected(name, file); });
        if (files.size() > before) continue;
        std::vector<std::string> known;
        for (const std::string& file : shipped) known.push_back(fs::path(file).stem().string());
        throw InputError(kOption,
                         relief::unknownName({"what", MessageId::WordPaperFigure}, name, relief::commaList(known)));
    }
    return files;
}

void writePaperFigure(const PaperFigure& figure, const std::string& folder, const std::string& version,
                      const LanguageSetter& installLanguage, relief::Work& work) {
    nlohmann::json made = figure.json;  // its keys are sorted
    const auto path = [&](const std::string& name) { return (fs::path(folder) / name).string(); };
    for (std::size_t part = 0; part < figure.parts.size(); ++part) {
        const PaperFigure::Part& one = figure.parts[part];
        SnapshotMaker maker;
        SnapshotOrder order;
        order.scenario = one.scenario;
        order.layer = layerNamed(one.layer).value_or(Layer::Color);
        const auto snapshot = maker.make(order, work);
        inEachLanguage([&](std::size_t, Language language) {
            installLanguage(language);
            FigurePage page;
            page.title = figure.name;
            page.widthMm = one.widthMm;
            page.caption = false;
            page.style.theme = Theme::Light;
            page.style.language = language;
            auto drawn = one.kind.make(snapshot, snapshot->scenario);
            if (!drawn->vectors()) drawn = asPicture(*drawn, page, work);
            for (const char* const ending : kEndings) {
                const std::string name = pictureNames(figure, language)[part] + ending;
                writeFigure(*drawn, page, path(name), work);
                made["files"][name] = checksum(path(name));
            }
        });
    }
    inEachLanguage([&](std::size_t n, Language language) {
        const std::string name = figure.name + "-" + languageCode(language) + ".tex";
        relief::writeTextFile(path(name), texFigure(figure, n));
        made["files"][name] = checksum(path(name));
    });
    made["command"] = commandOf(figure);
    made["program"] = "reliefscope " + version;
    relief::writeTextFile(path(figure.name + ".json"), made.dump(kIndent) + "\n");
}

void writePaperDocuments(const std::vector<PaperFigure>& figures, const std::string& folder) {
    inEachLanguage([&](std::size_t, Language language) {
        const std::string code = languageCode(language);
        std::string tex = "\\documentclass[a4paper]{article}\n\\usepackage[margin=15mm]{geometry}\n";
        tex +=
            "\\usepackage{graphicx,iftex}\n\\ifPDFTeX\n\\usepackage[T1,T2A]{fontenc}\n\\usepackage[utf8]{inputenc}\n";
        tex += "\\else\n\\usepackage{fontspec}\n\\setmainfont{DejaVu Serif}\n\\fi\n";
        if (language == Language::Ukrainian) tex += "\\usepackage[ukrainian]{babel}\n";
        tex += "\\begin{document}\n";
        for (const PaperFigure& figure : figures) tex += "\\input{" + figure.name + "-" + code + "}\n\\clearpage\n";
        relief::writeTextFile((fs::path(folder) / ("all-" + code + ".tex")).string(), tex + "\\end{document}\n");
    });
}

}  // namespace reliefui
