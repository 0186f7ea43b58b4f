// relief make RELIEF -o FILE [--size N|WxH] [--seed S]
#include "options_common.h"
#include "output.h"
#include "relief/files.h"
#include "relief/reliefs.h"

namespace relief::app {

namespace {

struct MakeOptions {
    OptionText relief, output, size, seed;
    RunOptions run;
};

const ReliefRecipe& findRecipe(const std::string& name) {
    std::string known;
    for (const ReliefRecipe& recipe : reliefRecipes()) {
        if (recipe.name == name) return recipe;
        known.append(known.empty() ? "" : ", ").append(recipe.name);
    }
    throw InputError("", unknownName({"what", MessageId::WordRelief}, name, known));
}

// "N" or "WxH".
SizeText makeSize(const MakeOptions& options, const ReliefRecipe& recipe) {
    if (!options.size) return {recipe.defaultSize, recipe.defaultSize};
    if (options.size->find('x') != std::string::npos) return parseSize(*options.size, "--size", kMaxPictureSide);
    const int side = static_cast<int>(parseWhole(*options.size, "--size", 1, kMaxPictureSide));
    return {side, side};
}

// As many as a height map may have when it is read again.
void checkTexels(const SizeText& size) {
    const std::int64_t texels = std::int64_t{size.width} * size.height;
    if (texels <= kDefaultMaxPixels) return;
    const Message range(MessageId::RangeOfUnit,
                        {{"low", 1}, {"high", kDefaultMaxPixels}, {"unit", MessageId::UnitTexels}});
    throw InputError("--size", Message(MessageId::NumberOutOfRange, {{"value", texels}, {"range", range}}));
}

int runMake(const MakeOptions& options, Session& session) {
    options.run.apply(session);
    const ReliefRecipe& recipe = findRecipe(needed(options.relief, "RELIEF", "make"));
    const std::string& output = needed(options.output, "--output", "make");
    checkOutput(output, {"png", "tif", "tiff", "exr"});
    const SizeText size = makeSize(options, recipe);
    checkTexels(size);
    const std::uint64_t seed = options.seed ? parseSeed(*options.seed, "--seed") : 1;
    const FloatImage heights = makeRelief(recipe.name, size.width, size.height, seed);
    if (session.stop().stop_requested()) throw Cancelled();
    writeHeight(output, heights, fileEnding(output) == "exr");
    return 0;
}

}  // namespace

void addMakeCommand(CLI::App& program, Commands& commands) {
    auto options = std::make_shared<MakeOptions>();
    std::string names;
    for (const ReliefRecipe& recipe : reliefRecipes()) names.append(names.empty() ? "" : ", ").append(recipe.name);
    CLI::App* parser = addCommand(
        program, "make", "make a procedural height map",
        "Writes a height map made by a recipe: the same bits for the same seed on every machine. .png and .tif hold "
        "16-bit integers, .exr 32-bit floats. The recipes: " +
            names + "; relief list tells what each is.",
        "  relief make bricks --size 512 --seed 7 -o bricks.png");
    addArgument(*parser, "RELIEF", options->relief, "name of the recipe");
    addOutput(*parser, options->output, "the height map: .png, .tif or .exr");
    addText(*parser, "--size", options->size, "N|WxH",
            "texels, 1 to " + std::to_string(kMaxPictureSide) + " a side, " + std::to_string(kDefaultMaxPixels) +
                " in all; default: the recipe's own (256 mostly)",
            "Relief");
    addText(*parser, "--seed", options->seed, "S", "of the random numbers, a whole number from 0; default 1", "Relief");
    options->run.add(*parser, false);
    commands.push_back({parser, [options](Session& session) { return runMake(*options, session); }});
}

}  // namespace relief::app
