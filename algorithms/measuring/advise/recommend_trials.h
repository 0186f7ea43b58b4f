// What advice is drawn from: forms of methods made ready, counted and timed on rays that all of them share.
#pragma once

#include <chrono>
#include <map>

#include "measuring/advise/recommend.h"

namespace relief {

struct AdviceTrial {
    AdvisedForm facts;
    std::shared_ptr<const Tracer> tracer;  // none: dropped
    std::vector<double> times;             // of each round: processor seconds a ray
};

// The rays of all views with the exact answers: blocks of a view are pictures of the whole map from as many azimuths.
class AdviceRays {
  public:
    static constexpr std::size_t kBlocks = 8;

    AdviceRays(const AdviceOptions& options, std::uint64_t seed, Work& work);

    // Steps, reads, errors and cost (Scalar) over blocks [0, blocks) of each view.
    void count(AdviceTrial& trial, std::size_t blocks, Work& work) const;
    // One round of one form: that block of each view, on the calling thread.
    void time(AdviceTrial& trial, std::size_t block, Work& work) const;
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

// Makes forms, each map once; tells how long each map took to build.
class AdviceMaps {
  public:
    AdviceMaps(const AdviceOptions& options, Work& work);

    // Sets tracer, guarantee, bytes, build time; or the verdict. limit: seconds for this one.
    void make(AdviceTrial& trial, double limit);

  private:
    std::unique_ptr<Tracer> built(const MethodChoice& method, double limit, double& seconds);
    bool fits(AdviceTrial& trial, double limit);

    const AdviceOptions& options_;
    Work& work_;
    MapCache maps_;
    std::map<std::string, double> seconds_;  // of maps that were built, by what they depend on
};

// Every form built, screened and, in the rounds, dropped or kept. keepAll: dropped forms keep their tracers.
// Trials in the order of options.forms.
std::vector<AdviceTrial> runTrials(const AdviceOptions& options, bool keepAll, std::size_t& stillClose, Work& work);
Advice adviceOf(const AdviceOptions& options, const std::vector<AdviceTrial>& trials);
// Forms whose cost is within that share of the best one's are as good: the leaner one is taken.
inline constexpr double kAdviceTie = 0.03;

}  // namespace relief
