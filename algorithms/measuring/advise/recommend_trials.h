// The measurements on which advice is based: forms of methods are built, counted and timed on rays that all of them
// share.
#pragma once

#include <chrono>
#include <map>

#include "measuring/advise/recommend.h"

namespace relief {

// Returns a piece from the middle of the map, at most `side` texels long and wide, with the same slab thickness in
// texels.
HeightField middlePiece(const HeightField& field, int side);

struct AdviceTrial {
    AdvisedForm facts;
    std::shared_ptr<const Tracer> tracer;  // null: the form was dropped
    std::vector<double> times;             // processor seconds per ray, by round
    std::size_t blocks = 0;                // blocks of each view on which the form was counted
};

// The rays of all views and their exact answers. The blocks of a view are pictures of the whole map from different
// azimuths.
class AdviceRays {
  public:
    static constexpr std::size_t kBlocks = 8;

    // Traces all rays with `exact` to get the reference answers. Keeps a reference to options.
    AdviceRays(const AdviceOptions& options, std::uint64_t seed, Work& work);

    // Sets steps, reads, errors and (Form::Scalar) cost, from blocks [0, blocks) of each view.
    void count(AdviceTrial& trial, std::size_t blocks, Work& work) const;
    // Measures one round of one form, on this block of each view, on the calling thread.
    void time(AdviceTrial& trial, std::size_t block, Work& work) const;
    // Returns true if the share of rays past the error bound, or past the step limit, is at most
    // AdviceOptions::outliers.
    bool keepsBound(const AdvisedForm& facts) const;
    bool keepsSteps(const AdvisedForm& facts) const;

  private:
    struct Block {
        RayBlock rays;
        HitBlock truth;
    };
    const AdviceOptions& options_;
    std::vector<std::vector<Block>> views_;
};

// Builds forms, each map only once, and records how long each map took.
class AdviceMaps {
  public:
    // Keeps references to options and work.
    AdviceMaps(const AdviceOptions& options, Work& work);

    // Sets tracer, guarantee, bytes and build time, or the verdict if the form cannot be built. limit: seconds for this
    // form.
    void make(AdviceTrial& trial, double limit);

  private:
    std::unique_ptr<Tracer> built(const MethodChoice& method, double limit, double& seconds);
    bool fits(AdviceTrial& trial, double limit);

    const AdviceOptions& options_;
    Work& work_;
    MapCache maps_;
    std::map<std::string, double> seconds_;  // building times of maps, by the map and its options
};

// Builds and screens every form, and drops or keeps it in the rounds. keepAll: dropped forms keep their tracers.
// Returns the trials in the order of options.forms.
std::vector<AdviceTrial> runTrials(const AdviceOptions& options, bool keepAll, std::size_t& stillClose, Work& work);
// Ranks the trials, and chooses a form.
Advice adviceOf(const AdviceOptions& options, const std::vector<AdviceTrial>& trials);
// Forms whose cost is within this share of the best one's count as equal, and the one with the smallest map is chosen.
inline constexpr double kAdviceTie = 0.03;

}  // namespace relief
