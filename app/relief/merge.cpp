// relief merge FILE... [-o OUT]: joins the parts of one run (--part K/N) into the output that one process would have
// written.
#include <fcntl.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include "help_formatter.h"
#include "images/file_descriptor.h"
#include "images/picture_bands.h"
#include "images/placed_file.h"
#include "images/system_error.h"
#include "merge_tables.h"
#include "options_common.h"
#include "output.h"

namespace relief::app {

namespace {

struct MergeOptions {
    std::vector<std::string> files;
    OptionText output;
    RunOptions run;
};

enum class Content : std::uint8_t { Table, Record, Picture };

// A part as read from its file; `text` is empty if it is a picture.
struct MergedPart : TextPart {
    Content content = Content::Table;
    ImageInfo info{};    // of a picture only
    std::string line{};  // the part line as it stands in a picture
};

[[noreturn]] void failNoPart(const std::string& path) {
    throw InputError(path, Message(MessageId::PartNone));
}

// Returns the first character of a regular file; 0 if there is none. Throws InputError if it cannot be read.
char firstLetter(const std::string& path) {
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(path, error);
    if (error) throw InputError(path, systemMessage(error.value(), FileAccess::Read));
    char letter = 0;
    if (!std::filesystem::is_regular_file(status)) return letter;
    const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
    if (!file.open() || readAt(file.number(), 0, &letter, 1) < 0)
        throw InputError(path, systemMessage(errno, FileAccess::Read));
    return letter;
}

MergedPart readPicture(const std::string& path) {
    MergedPart read;
    read.path = path;
    read.content = Content::Picture;
    BandFile band = readBandFile(path);
    auto part = parsePartLine(band.text);
    if (!part) failNoPart(path);
    read.part = std::move(*part);
    read.info = std::move(band.info);
    read.line = std::move(band.text);
    return read;
}

MergedPart readText(const std::string& path, Content content) {
    MergedPart read;
    read.path = path;
    read.content = content;
    read.text = readTextFile(path);
    const std::size_t end = read.text.find('\n');
    if (end == std::string::npos) failNoPart(path);
    const std::size_t begin = content == Content::Table ? 1 : 0;
    auto part = parsePartLine(std::string_view(read.text).substr(begin, end - begin));
    if (!part) failNoPart(path);
    read.part = std::move(*part);
    read.body = end + 1;
    return read;
}

// The type of the file is determined by its content, not by its name.
MergedPart readPart(const std::string& path) {
    const std::string ending = fileEnding(path);
    const char letter = firstLetter(path);
    if (letter == '#') return readText(path, Content::Table);
    if (letter == '{') return readText(path, Content::Record);
    if (ending == "csv" || ending == "json" || ending == "jsonl") failNoPart(path);
    return readPicture(path);
}

// Throws InputError unless the bands cover every row of the whole picture exactly once.
void checkBands(const std::vector<MergedPart>& parts) {
    int done = 0;
    for (const MergedPart& part : parts) {
        const auto number = [&](const char* name) {
            const auto found = part.part.more.find(name);
            const bool whole =
                found != part.part.more.end() && found->is_number_unsigned() && *found <= kMaxPictureSide;
            return whole ? found->get<int>() : -1;
        };
        const int end = number("end");
        const bool last = part.part.part == part.part.of;
        if (number("first") != done || end - done != part.info.height || (last && number("height") != end)) {
            throw InputError(part.path, Message(MessageId::FileTruncated));
        }
        done = end;
    }
}

// Returns the part as a file of rows at their places. Throws InputError if it is none.
PlacedPart placedPart(const MergedPart& part, int height) {
    const Json& more = part.part.more;
    const bool exr = part.info.format == "openexr", last = part.part.part == part.part.of;
    const int begin = more.at("first").get<int>(), end = more.at("end").get<int>();
    const bool groups = begin % PictureLayout::kGroup == 0 && (last || end % PictureLayout::kGroup == 0) && begin < end;
    const std::vector<std::string>& channels = part.info.channels;
    const bool rgb = channels == std::vector<std::string>{"R", "G", "B"};
    if (!groups || more.value("tiled", Json()) != Json(true) || (!exr && !rgb)) {
        throw InputError(part.path, Message(MessageId::FileTruncated));
    }
    return {part.path, PictureLayout({exr, part.info.width, height, begin, end, channels, part.line})};
}

void mergePictures(const std::vector<MergedPart>& parts, const std::string& output, Session& session) {
    const std::string& format = parts.front().info.format;
    checkOutput(output, format == "tiff"      ? std::vector<std::string>{"tif", "tiff"}
                        : format == "openexr" ? std::vector<std::string>{"exr"}
                                              : std::vector<std::string>{format});
    checkBands(parts);
    if (parts.front().part.more.contains("tiled")) {
        std::vector<PlacedPart> placed;
        for (const MergedPart& part : parts) {
            if (part.info.width != parts.front().info.width || part.info.channels != parts.front().info.channels) {
                throw InputError(part.path, Message(MessageId::BandMisfit, {{"other", parts.front().path}}));
            }
            placed.push_back(placedPart(part, parts.back().part.more.at("end").get<int>()));
        }
        joinPlaced(placed, output, session.work());
        return;
    }
    std::vector<std::string> files;
    for (const MergedPart& part : parts) files.push_back(part.path);
    joinBands(files, output, session.work());
}

int runMerge(const MergeOptions& options, Session& session) {
    options.run.apply(session);
    if (options.files.empty()) needed(std::nullopt, "FILE", "merge");
    std::vector<MergedPart> parts;
    std::vector<PartFile> numbers;
    refuseOverwriting("--output", options.output.value_or(""), options.files);
    for (const std::string& path : options.files) {
        parts.push_back(readPart(path));
        if (parts.back().content != parts.front().content) {
            throw InputError(path, Message(MessageId::PartOtherKind, {{"other", parts.front().path}}));
        }
        numbers.push_back(parts.back());
    }
    requireWholeRun(numbers);
    std::sort(parts.begin(), parts.end(),
              [](const MergedPart& a, const MergedPart& b) { return a.part.part < b.part.part; });
    const Content content = parts.front().content;
    if (content == Content::Picture) {
        mergePictures(parts, needed(options.output, "--output", "merge"), session);
        return 0;
    }
    std::vector<TextPart> texts;
    for (MergedPart& part : parts) texts.push_back(std::move(part));
    if (content == Content::Record) return mergeRecords(texts, options.output, session);
    mergeTables(texts, needed(options.output, "--output", "merge"), session);
    return 0;
}

}  // namespace

void addMergeCommand(CLI::App& program, Commands& commands) {
    auto options = std::make_shared<MergeOptions>();
    CLI::App* parser =
        addCommand(program, "merge", "join the parts of one run",
                   "Joins the files that bench, render or stress wrote with --part K/N, in any order, into the output "
                   "of a single process: the table, the picture, or the report of the stress test (to standard output; "
                   "with -o also its record), without its run time. The kind of the files is recognised from their "
                   "contents. A part that is missing, given twice or of a different run (commit, seed or option) is "
                   "refused with exit status 2. The exit status is 1 if the parts of a stress test contain violations.",
                   "  relief merge city1.png city2.png -o city.png\n"
                   "  relief merge stress?.jsonl");
    parser->add_option("FILE", options->files, "all parts of one run")
        ->type_name("")
        ->group("Arguments")
        ->option_text(kNeeded);
    addOutput(
        *parser, options->output,
        "table: .csv or .json; picture: .png, .tif or .exr, like its parts; record of a stress test: .jsonl, optional");
    options->run.add(*parser, false);
    commands.push_back({parser, [options](Session& session) { return runMerge(*options, session); }});
}

}  // namespace relief::app
