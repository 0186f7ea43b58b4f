// Frames as the window requests them, at random: each request changes something of the one before or goes back to an
// earlier one, many are cancelled at a random moment, and maps and buffers are kept throughout. Whatever came before,
// a finished frame has the bits of the same frame rendered alone.
#include <chrono>
#include <cstdlib>
#include <deque>
#include <iostream>
#include <random>
#include <stop_token>
#include <thread>

#include <gtest/gtest.h>

#include "algorithms/relief/fields.h"
#include "rendering/progressive.h"

namespace relief::test {
namespace {

constexpr int kEarlier = 12;              // requests that may be gone back to
constexpr double kBudget = 0.001;         // seconds for a moving frame
constexpr int kFactors[]{1, 2, 3, 8};     // a coarser picture is this many times smaller
constexpr double kLongestCancel = 0.004;  // seconds after which a frame is cancelled at the latest

template <class Value>
const Value& anyOf(const std::vector<Value>& values, Random& random) {
    return values[static_cast<std::size_t>(random.below(static_cast<int>(values.size())))];
}

class Requests {
  public:
    explicit Requests(std::uint64_t seed) : random_(seed), request_(HeightField(relief("bricks"))) {
        for (const MethodDescription& method : tracerList()) {
            methods_.push_back({method.name, {}});
            if (method.kind != MethodKind::Tracer) methods_.push_back({"max-pyramid", {}});
        }
        for (const MethodChoice& choice : allChoices()) methods_.push_back(choice);
        for (int seed1 = 1; seed1 <= 2; ++seed1) {
            ColorImage image(24, 20);
            for (Color& color : image.pixels()) {
                color = Color(static_cast<float>(random_.unit()), static_cast<float>(random_.unit()), 0.5F);
            }
            colors_.push_back(std::make_shared<ColorImage>(std::move(image)));
        }
        request_.color = colors_[0];
        request_.width = request_.height = 24;
    }

    const FrameRequest& next() {
        if (!earlier_.empty() && random_.below(6) == 0) {
            request_ = earlier_[static_cast<std::size_t>(random_.below(static_cast<int>(earlier_.size())))];
        } else {
            for (int n = 1 + random_.below(2); n > 0; --n) change();
        }
        // Methods are asked for what they support; the window refuses the rest before it requests a frame.
        if (!supports(request_.method, request_.field.surface(), request_.field.address())) request_.method = {};
        if (request_.method.name.empty()) request_.method = {"max-pyramid", {}};
        // Sums over the surface are slow.
        const auto form = request_.filter.options.find("form");
        const bool slow = form != request_.filter.options.end() && form->second.starts_with("position");
        if (slow) request_.width = std::min(request_.width, 12), request_.height = std::min(request_.height, 12);
        earlier_.push_back(request_);
        if (earlier_.size() > kEarlier) earlier_.pop_front();
        return request_;
    }

  private:
    Heights relief(const std::string& name) { return share(makeRelief(name, 24, 20, 1)); }
    void setField(const Heights& heights, Surface surface, Address address, double depth) {
        request_.field = HeightField(heights, surface, address, depth);
    }

    void change() {
        FrameRequest& r = request_;
        const HeightField f = r.field;
        switch (random_.below(19)) {
            case 0:
                r.width = 8 + random_.below(60);
                break;
            case 1:
                r.height = 8 + random_.below(40);
                break;
            case 2:
                setField(f.sharedHeights(), anyOf(allSurfaces(), random_), f.address(), f.reliefDepth());
                break;
            case 3:
                setField(f.sharedHeights(), f.surface(), anyOf(allAddresses(), random_), f.reliefDepth());
                break;
            case 4:
                setField(f.sharedHeights(), f.surface(), f.address(), random_.between(0.02, 0.5));
                break;
            case 5: {
                static const std::vector<std::string> kReliefs{"bricks", "spikes", "hills", "city", "steps"};
                setField(relief(anyOf(kReliefs, random_)), f.surface(), f.address(), f.reliefDepth());
                break;
            }
            case 6:
            case 7: {  // edited by hand
                FloatImage image = f.heights();
                for (int n = random_.below(4); n >= 0; --n) {
                    image(random_.below(image.width()), random_.below(image.height())) =
                        static_cast<float>(random_.unit());
                }
                setField(share(std::move(image)), f.surface(), f.address(), f.reliefDepth());
                break;
            }
            case 8:
            case 9:
                r.method = anyOf(methods_, random_);
                break;
            case 10:
                r.color = random_.below(4) == 0 ? nullptr : anyOf(colors_, random_);
                break;
            case 11:
                r.filter = anyOf(filterForms(), random_);
                r.filter.samples = 2;
                break;
            case 12:
                r.scene = static_cast<SceneKind>(random_.below(3));
                break;
            case 13:
            case 14:
                r.camera.azimuth += random_.between(-30, 30);
                break;
            case 15:
                r.camera.elevation = random_.between(12, 85);
                break;
            case 16:
                r.light.azimuth += random_.between(-90, 90);
                r.light.elevation = random_.between(5, 85);
                break;
            case 17:
                r.shadows = !r.shadows;
                break;
            default:
                r.bounded = random_.below(3) == 0 ? kMaxBounded : 0;
                r.skip = random_.below(4) != 0;
                r.mapping.variant = random_.below(2) == 0 ? RowVariant::Direct : RowVariant::Affine;
        }
    }

    Random random_;
    FrameRequest request_;
    std::vector<MethodChoice> methods_;
    std::vector<std::shared_ptr<const ColorImage>> colors_;
    std::deque<FrameRequest> earlier_;
};

// Requests a stop from another thread after a time, or from the listener of the progress at a fraction of any stage.
class Canceller {
  public:
    Canceller(Random& random, bool cancels) {
        const int how = cancels ? random.below(2) : -1;
        if (how == 0) fraction_ = random.unit();
        if (how == 1) {
            const auto after = std::chrono::duration<double>(random.unit() * random.unit() * kLongestCancel);
            thread_ = std::jthread([this, after](const std::stop_token&) {
                std::this_thread::sleep_for(after);
                source_.request_stop();
            });
        }
    }
    std::stop_token token() const { return source_.get_token(); }
    void progress(double done) {
        if (done >= fraction_) source_.request_stop();
    }

  private:
    std::stop_source source_;
    double fraction_ = 2;  // of a stage; never reached
    std::jthread thread_;
};

// Returns a random level; the renderer's own choice depends on the machine's speed.
MovingLevel anyLevel(const FrameRequest& request, Random& random) {
    const int filter = static_cast<int>(random.below(kCoarsestFilter + 1));
    const int factor = kFactors[random.below(std::size(kFactors))];
    const bool full = filter == 0 && factor == 1;
    return {full ? 0 : 1, coarserFilter(request.filter, filter), factor, kBudget};
}

void expectSame(const Frame& frame, const FrameRequest& request) {
    Work work(1);
    FrameRenderer renderer(std::make_shared<MapCache>());
    auto alone = renderer.render(request, work);
    if (frame.hits->counted()) alone = renderer.counted(work);
    ASSERT_TRUE(frame.light->color == alone->light->color);
    ASSERT_TRUE(frame.color->color == alone->color->color);
    ASSERT_EQ(frame.hits->hits.size(), alone->hits->hits.size());
    for (std::size_t i = 0; i < alone->hits->hits.size(); ++i) {
        ASSERT_TRUE(sameBits(frame.hits->hits[i], alone->hits->hits[i])) << "pixel " << i;
    }
    if (frame.hits->counted()) {
        ASSERT_EQ(frame.hits->hits.steps, alone->hits->hits.steps);
        ASSERT_EQ(frame.hits->hits.reads, alone->hits->hits.reads);
    }
}

TEST(RandomFrames, AreThoseRenderedAloneWhateverWasCancelledBefore) {
    const bool isLong = std::getenv("RELIEF_LONG") != nullptr;
    const int frames = isLong ? 10'000 : 300;
    const std::uint64_t seed = std::random_device{}();
    std::cout << "seed " << seed << "\n";
    Random random(seed);
    Requests requests(random.bits());
    ProgressiveRenderer renderer(std::make_shared<MapCache>(), kBudget);
    int cancelled = 0, finished = 0, coarse = 0, counted = 0;
    while (finished < frames) {
        const FrameRequest request = requests.next();
        SCOPED_TRACE("frame " + std::to_string(finished) + ", " + describe(request.method) + ", " +
                     filterText(request.filter) + ", " + describe(request.field));
        const bool moves = random.below(3) == 0, counts = random.below(4) == 0, chooses = random.below(2) == 0;
        const MovingLevel chosen = anyLevel(request, random);
        Canceller canceller(random, random.below(2) == 0);
        Work work(1 + random.below(2), canceller.token(),
                  [&](std::string_view, double done) { canceller.progress(done); });
        try {
            const auto picture = !moves    ? renderer.atRest(request, work)
                                 : chooses ? renderer.draw(request, chosen, work)
                                           : renderer.moving(request, work);
            const auto frame = counts ? renderer.counted(picture, work) : picture.frame;
            ++finished, coarse += picture.level.number > 0 ? 1 : 0, counted += counts ? 1 : 0;
            ASSERT_NO_FATAL_FAILURE(expectSame(*frame, moves ? coarserRequest(request, picture.level) : request));
        } catch (const Cancelled&) {
            ++cancelled;
        }
    }
    std::cout << finished << " frames, of them " << coarse << " coarser and " << counted << " counted; " << cancelled
              << " more were cancelled\n";
    EXPECT_GT(cancelled, frames / 20);
    EXPECT_GT(coarse, frames / 20);
}

}  // namespace
}  // namespace relief::test
