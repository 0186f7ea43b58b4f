// relief make RELIEF[:SIZE[:SEED]] -o FILE [--size SIZE] [--seed S]
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

// "bricks:512:7" is the same as `bricks --size 512 --seed 7`.
Pictures chosenRelief(const MakeOptions& options) {
    const std::string& relief = needed(options.relief, "RELIEF", "make");
    const std::size_t parts = splitText(relief, ':').size();
    if (options.size && parts > 1)
        throw InputError("--size", Message(MessageId::ArgumentsExclude, {{"other", relief}}));
    if (options.seed && parts > 2)
        throw InputError("--seed", Message(MessageId::ArgumentsExclude, {{"other", relief}}));
    Pictures pictures;
    applyRecipe(pictures, relief, {});
    if (options.seed) pictures.seed = parseSeed(*options.seed, "--seed");
    if (!options.size) return pictures;
    const SizeText size = parseSize(*options.size, "--size", kMaxPictureSide);
    pictures.recipeWidth = size.width;
    pictures.recipeHeight = size.height;
    // The limit that applies when the height map is read again.
    const std::int64_t texels = std::int64_t{size.width} * size.height;
    if (texels <= kDefaultMaxPixels) return pictures;
    const Message range(MessageId::RangeOfUnit,
                        {{"low", 1}, {"high", kDefaultMaxPixels}, {"unit", MessageId::UnitTexels}});
    throw InputError("--size", Message(MessageId::NumberOutOfRange, {{"value", texels}, {"range", range}}));
}

int runMake(const MakeOptions& options, Session& session) {
    options.run.apply(session);
    const Pictures pictures = chosenRelief(options);
    const std::string& output = needed(options.output, "--output", "make");
    checkOutput(output, {"png", "tif", "tiff", "exr"});
    AssetStore store;
    const Assets assets = store.load(pictures, session.work());
    session.eraseBar();
    writeHeight(output, *assets.heights, fileEnding(output) == "exr");
    return kDone;
}

}  // namespace

void addMakeCommand(CLI::App& program, Commands& commands) {
    auto options = std::make_shared<MakeOptions>();
    std::string names;
    for (const ReliefRecipe& recipe : reliefRecipes()) names.append(names.empty() ? "" : ", ").append(recipe.name);
    CLI::App* parser = addCommand(program, "make", "make a procedural height map",
                                  "Writes a procedural height map. The same seed gives the same bits on every machine. "
                                  ".png and .tif hold 16-bit integers, .exr 32-bit floats. The reliefs: " +
                                      names + "; relief list reliefs describes them.",
                                  "  relief make bricks --size 512 --seed 7 -o bricks.png\n"
                                  "  relief make bricks:512x256:7 -o bricks.png");
    addArgument(*parser, "RELIEF", options->relief, "name of the relief; size and seed may follow, as in bricks:512:7");
    addOutput(*parser, options->output, "the height map: .png, .tif or .exr");
    addText(*parser, "--size", options->size, "WxH|N",
            "size in texels, 1 to " + std::to_string(kMaxPictureSide) + " per side, " +
                std::to_string(kDefaultMaxPixels) + " in all; N: N x N; default: that of the relief, mostly 256",
            "Relief");
    addText(*parser, "--seed", options->seed, "S", "seed of the random numbers, a whole number from 0; default 1",
            "Relief");
    options->run.add(*parser, false);
    commands.push_back({parser, [options](Session& session) { return runMake(*options, session); }});
}

}  // namespace relief::app
