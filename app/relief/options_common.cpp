#include "options_common.h"

#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include "help_formatter.h"
#include "measuring/text_table.h"
#include "output.h"
#include "relief/describe.h"
#include "rendering/base_level.h"
#include "team.h"

namespace relief::app {

CLI::App* addCommand(CLI::App& program, const std::string& name, const std::string& summary,
                     const std::string& paragraph, const std::string& examples) {
    CLI::App* parser = program.add_subcommand(name, summary + "\n" + paragraph);
    parser->group("Commands");
    parser->set_help_flag("-h,--help", "show this page and exit")->group("General");
    parser->footer("Example:\n" + examples);
    return parser;
}

std::string rangeText(const OptionDescription& number) {
    const std::string unit = number.unit.empty() || number.unit == "level" ? "" : " " + number.unit;
    return numberText(number.low) + " to " + numberText(number.high) + unit;
}

CLI::Option* addText(CLI::App& parser, const std::string& names, OptionText& target, const std::string& kind,
                     const std::string& help, const std::string& group) {
    // Not bound as std::optional: CLI11 would treat an empty string as "not given".
    CLI::Option* option = parser.add_option_function<std::string>(
        names, [&target](const std::string& text) { target = text; }, help);
    return option->type_name(kind)->group(group);
}

void addArgument(CLI::App& parser, const std::string& name, OptionText& target, const std::string& help) {
    addText(parser, name, target, "", help, "Arguments")->option_text(kNeeded);
}

CLI::Option* addTexts(CLI::App& parser, const std::string& names, std::vector<std::string>& target,
                      const std::string& kind, const std::string& help, const std::string& group) {
    return parser.add_option(names, target, help)->allow_extra_args(false)->type_name(kind)->group(group);
}

CLI::Option* addFlag(CLI::App& parser, const std::string& names, bool& target, const std::string& help,
                     const std::string& group) {
    return parser.add_flag(names, target, help)->group(group);
}

void addOutput(CLI::App& parser, OptionText& target, const std::string& help) {
    addText(parser, "-o,--output", target, "FILE", help, "Output");
}

const std::string& needed(const OptionText& value, const std::string& option, const std::string& command) {
    if (!value || value->empty()) {
        throw InputError(option, Message(MessageId::ArgumentMissing, {{"help", "relief " + command + " --help"}}));
    }
    return *value;
}

std::int64_t parseWhole(const std::string& text, const std::string& option, std::int64_t low, std::int64_t high) {
    std::int64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error == std::errc::invalid_argument || end != text.data() + text.size()) {
        throw InputError(option, Message(MessageId::NotAWholeNumber, {{"text", text}}));
    }
    if (error != std::errc() || value < low || value > high) {
        throw InputError(option,
                         Message(MessageId::NumberOutOfRange, {{"value", text}, {"range", rangeOf(low, high)}}));
    }
    return value;
}

std::uint64_t parseSeed(const std::string& text, const std::string& option) {
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) {
        throw InputError(option, Message(MessageId::NotASeed, {{"text", text}}));
    }
    return value;
}

SizeText parseSize(const std::string& text, const std::string& option, int largest) {
    std::vector<std::string> parts = splitText(text, 'x');
    if (parts.size() == 1) parts.push_back(parts.front());
    if (parts.size() != 2) throw InputError(option, Message(MessageId::NotASize, {{"text", text}}));
    for (const std::string& part : parts) {
        if (part.empty() || part.find_first_not_of("0123456789") != std::string::npos) {
            throw InputError(option, Message(MessageId::NotASize, {{"text", text}}));
        }
    }
    return {static_cast<int>(parseWhole(parts[0], option, 1, largest)),
            static_cast<int>(parseWhole(parts[1], option, 1, largest))};
}

int parseSide(const std::string& text, const std::string& option, int largest) {
    const SizeText size = parseSize(text, option, largest);
    if (size.width == size.height) return size.width;
    throw InputError(option, Message(MessageId::SizeNotSquare, {{"width", size.width}, {"height", size.height}}));
}

bool isScenarioFile(const std::string& path) {
    if (fileEnding(path) == "json") return true;
    std::error_code none;
    const auto status = std::filesystem::status(path, none);
    // Pictures cannot be read from pipes.
    if (!std::filesystem::is_regular_file(status)) {
        return std::filesystem::exists(status) && !std::filesystem::is_directory(status);
    }
    char letter = 0;
    std::ifstream(path, std::ios::binary) >> letter;  // the first character that is not white space
    return letter == '{';
}

PixelChoice parsePixel(const std::string& text, const std::string& option) {
    const std::vector<std::string> parts = splitText(text, ',');
    if (parts.size() != 2) throw InputError(option, Message(MessageId::NotAPixel, {{"text", text}}));
    constexpr int kLargest = kMaxPictureSide - 1;
    return {static_cast<int>(parseWhole(parts[0], option, 0, kLargest)),
            static_cast<int>(parseWhole(parts[1], option, 0, kLargest))};
}

std::vector<std::string> splitText(const std::string& text, char separator) {
    std::vector<std::string> parts;
    std::size_t at = 0;
    while (true) {
        const std::size_t end = text.find(separator, at);
        parts.push_back(text.substr(at, end == std::string::npos ? end : end - at));
        if (end == std::string::npos) return parts;
        at = end + 1;
    }
}

void RunOptions::add(CLI::App& parser, bool withThreads) {
    if (withThreads) {
        addText(parser, "--threads", threads_, "N",
                "number of threads, 0 to 1024; 0 (default): as many as the machine offers. The result does not depend "
                "on it",
                "General");
    }
    CLI::Option* const quiet =
        addFlag(parser, "-q,--quiet", quiet_, "print no messages and no progress bar, only errors", "General");
    addFlag(parser, "-v,--verbose", verbose_,
            "print progress lines during long work even if standard error is not a terminal, for example in the log of "
            "a job",
            "General")
        ->excludes(quiet);
    addLanguage(parser);
}

void RunOptions::apply(Session& session, bool withoutOthers) const {
    session.setQuiet(quiet_ || !leadsRun(withoutOthers));
    session.setVerbose(verbose_);
    if (threads_) session.setThreads(static_cast<int>(parseWhole(*threads_, "--threads", 0, 1024)));
}

void RestartOptions::add(CLI::App& parser, const std::string& when, const std::string& group) {
    addFlag(parser, "--resume", resume_, when + ": continue from the .part file of a run that was stopped or killed",
            group);
    addFlag(parser, "--anew", anew_, when + ": discard that .part file and start again", group);
}

EarlierRun RestartOptions::chosen() const {
    if (resume_ && anew_) throw InputError("--anew", Message(MessageId::ArgumentsExclude, {{"other", "--resume"}}));
    if (resume_) return EarlierRun::Resume;
    return anew_ ? EarlierRun::Replace : EarlierRun::Refuse;
}

void addLanguage(CLI::App& parser) {
    // main() has already applied it: an error in these very options must be reported in that language, too.
    parser
        .add_option_function<std::string>(
            "--language", [](const std::string&) {}, "language of messages: en (default) or uk")
        ->type_name("en|uk")
        ->group("General");
}

void ReadingOptions::addForRows(CLI::App& parser, const char* group) {
    addText(parser, "--channel", channel_, "N|NAME",
            "channel that holds the heights: a number from 0, or a name (R, G, B, A, Y); default: grey, else the "
            "first. Other channels are never multiplied by alpha",
            group);
    addFlag(parser, "--invert", invert_, "the map stores depths: use 1 - h after scaling", group);
    addText(parser, "--range", range_, "auto|full|LO,HI",
            "scaling of the file's numbers to heights in [0, 1]. auto (default): integers by their full range, floats "
            "in [0, 1] unchanged, other floats stretched, with a message; full: never stretched; LO,HI: LO becomes 0, "
            "HI becomes 1, and numbers outside are clamped",
            group);
}

void ReadingOptions::add(CLI::App& parser, const char* group) {
    addForRows(parser, group);
    addText(parser, "--max-pixels", maxPixels_, "N",
            "largest number of pixels of a picture; larger ones are refused before memory is allocated. Default " +
                std::to_string(kDefaultMaxPixels),
            group);
}

void ReadingOptions::apply(HeightReadOptions& reading) const {
    if (channel_) reading.channel = *channel_;
    if (invert_) reading.invert = true;
    if (range_) reading.range = parseHeightRange(*range_);
    if (maxPixels_) reading.maxPixels = parseWhole(*maxPixels_, "--max-pixels", 1, std::int64_t{1} << 40);
}

std::string ReadingOptions::given() const {
    return channel_ ? "--channel" : invert_ ? "--invert" : range_ ? "--range" : maxPixels_ ? "--max-pixels" : "";
}

std::vector<std::string> inputFiles(const ScenarioOptions& options, const Scenario& scenario) {
    const Pictures& pictures = scenario.pictures;
    return {options.file().value_or(""), pictures.height, pictures.color, pictures.normal, options.map().value_or("")};
}

void noteHeights(Session& session, const Assets& assets, const Scenario& scenario) {
    const Pictures& pictures = scenario.pictures;
    const std::string name = pictures.recipe.empty() ? heightsName(pictures) : pictures.recipe;
    for (const Message& message : assets.height->notes) session.note(name, message);
}

void noteBaseLevel(Session& session, const Scenario& scenario, const FrameRequest& request) {
    if (scenario.method == request.method) return;
    const FootprintLevel level = footprintLevel(request);
    constexpr int kDigits = 3;
    session.note("--set", Message(MessageId::BaseAutoLevel,
                                  {{"level", level.level}, {"texels", readable(level.pixelTexels, kDigits)}}));
}

}  // namespace relief::app
