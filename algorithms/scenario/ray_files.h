// Rays, hits and step logs as text files. Numbers without the locale, 17 significant digits, so that they read back as
// the same doubles. Lines end in "\n"; "\r\n" and a byte order mark are accepted when reading.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

#include "relief/ray.h"
#include "relief/tracers.h"

namespace relief {

inline constexpr std::string_view kRaysHeader = "s0,t0,a,b";
inline constexpr std::string_view kHitsHeader = "outcome,lambda,s,t,steps";
// What every steps file has, and what follows: the kind of what a step looked at (subject::, kSubjectNames), and what
// that kind holds beside level, i, j, k and value; cells that it has no use for are empty.
//   sphere: s, t, z its centre; cone: s, t, z its apex, index the sector of count, width and height 1 if it is a cell's
//   voxel: width and height its footprint, count the layers; quad: s, t its first corner, width, height in texels
//   layer: index of count; texel: s, t the ray's coordinates on its level, where it goes on one level below
inline constexpr std::string_view kStepColumns =
    "ray,number,phase,level,i,j,k,lambda_in,lambda_out,z_in,z_out,value,decision,lambda_after";
inline constexpr std::array<std::string_view, 8> kSubjectColumns{"kind",  "s",      "t",     "z",
                                                                 "width", "height", "index", "count"};
inline constexpr std::string_view kStepsHeader =
    "ray,number,phase,level,i,j,k,lambda_in,lambda_out,z_in,z_out,value,decision,lambda_after,"
    "kind,s,t,z,width,height,index,count";

// Header first, then one ray a line. fileName: for messages. Throws InputError with the line's number: another header,
// not four numbers, a number that is not finite. Blank lines are accepted at the end only.
RayBlock parseRays(std::string_view text, const std::string& fileName);
// Steps as they are written below, CSV or JSON (the text begins with "["), of `rays` rays, counted from 0. The rays may
// come in any order and some be missing, the steps of one are together and count from 1. phase, i, j, k, z_in, z_out
// and all that belongs to the kind need not be known: in JSON they may be left out, in CSV the columns from `kind` on;
// columns of other names are passed over. InputError with the line: another header, wrong columns, an unknown decision,
// phase or kind, a number that is not finite, lambda outside of [0, 1] or before the part's begin, heights that are not
// 1 - lambda, steps out of order, a ray that the rays file has not.
// In files steps have no period, and in those of earlier versions no kind: placeSteps() finds them.
StepLog parseSteps(std::string_view text, const std::string& fileName, std::size_t rays);
// Which texels they are under repeat, by where ray number `number` is; a log that never speaks of cells is of points.
// InputError if the picture has no such texel.
void placeSteps(std::vector<Step>& steps, const ViewRay& ray, const HeightField& field, const std::string& fileName,
                std::size_t number);
// The answer that the log of a ray ends with; a log that ends otherwise: Limit.
Hit answerOf(const std::vector<Step>& steps, const ViewRay& ray);

// One ray as on the command line, "s0,t0,a,b"; throws InputError naming the option.
ViewRay parseRayText(const std::string& text, const std::string& option);

// "hit", "miss", "limit"; a ray that was never asked for (a pixel without polygon) is a miss.
std::string_view outcomeName(Outcome outcome);

// The lines of hits [first, last), without the header. Miss and limit leave lambda, s, t empty.
void appendHitLines(std::string& out, const HitBlock& hits, std::size_t first, std::size_t last);
// All of it, formatted in parallel, the same text for any number of threads. Throws Cancelled.
std::string hitLines(const HitBlock& hits, Work& work);

// The steps of ray `inLog` of the log, as ray number `ray`, steps counted from 1; without the header.
void appendStepLines(std::string& out, const StepLog& log, std::size_t inLog, std::size_t ray);
// The same as JSON objects, each followed by what stands between two of them. `empty`: nothing was written before.
void appendStepObjects(std::string& out, const StepLog& log, std::size_t inLog, std::size_t ray, bool& empty);

}  // namespace relief
