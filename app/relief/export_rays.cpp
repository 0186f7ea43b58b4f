// relief export rays PICTURE|SCENARIO.json [options of the view] -o FILE.csv
#include "export.h"
#include "output.h"
#include "scenario/ray_files.h"
#include "scenario/rays_view.h"

namespace relief::app {

namespace {

// Throws InputError if the rays or their view would replace a file of the command, or the view any other file than an
// earlier view: its name was not given, so nobody expects it to be written.
void refuseReplacing(const std::string& output, const std::string& view, std::vector<std::string> inputs) {
    refuseOverwriting("--output", output, inputs);
    if (!isRaysView(view)) inputs.push_back(view);
    refuseOverwriting("--output", output, inputs, view);
}

int runRays(const ExportOptions& given, Session& session) {
    const std::string& output = needed(given.output, "--output", "export rays");
    checkOutput(output, {"csv"});
    const std::string path = raysViewPath(output);
    Scenario scenario = given.scenario.scenario();
    refuseReplacing(output, path, inputFiles(given.scenario, scenario));
    // Rays depend on the size of the height map alone.
    scenario.pictures.color.clear();
    scenario.pictures.normal.clear();
    Work& work = session.work();
    AssetStore store;
    const Assets assets = store.load(scenario.pictures, work, true);
    noteHeights(session, assets, scenario);
    const FrameRequest request = frameRequest(scenario, assets);
    const ViewRays view = viewRays(request);
    if (view.rays.size() == 0) throw InputError("--camera", Message(MessageId::ViewNoRays));
    TextOutput rays(output, session.stop());
    TextOutput beside(path, session.stop());
    rays.write(std::string(kRaysHeader) + "\n" + rayLines(view.rays, work));
    beside.write(raysViewText(scenario, request, view, path));
    session.eraseBar();
    rays.commit();
    beside.commit();
    return kDone;
}

}  // namespace

ExportKind addRaysExport(CLI::App&) {
    return {
        "rays",
        "rays: writes the view ray of every pixel that sees the relief into FILE.csv, row by row from the top, with "
        "the header s0,t0,a,b (texels), as relief trace --rays and relief diagnose read them. FILE.json holds the "
        "view as a scenario, the matrices of camera and polygons, and the pixel and the polygon of each ray.",
        "  relief export rays heights.png --scene wall --size 400x300 -o rays.csv",
        {"FILE", "--height", "--relief", "--channel", "--invert", "--range", "--max-pixels", "--relief-depth",
         "--address", "--surface", "--scene", "--camera", "--eye", "--target", "--fov", "--size", "--mapping"},
        [](const ExportOptions& given, Session& session) { return runRays(given, session); }};
}

}  // namespace relief::app
