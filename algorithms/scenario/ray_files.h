// Text files of rays, hits and step logs. Numbers do not depend on the locale and have up to 17 significant digits, so
// that they read back as the same doubles. Lines end with "\n"; "\r\n" and a byte order mark are accepted when reading.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "relief/ray.h"
#include "relief/tracers.h"

namespace relief {

struct FurtherColumn;

inline constexpr std::string_view kRaysHeader = "s0,t0,a,b";
inline constexpr std::string_view kHitsHeader = "outcome,lambda,s,t,steps";
// kStepColumns: the columns that every steps file has. kSubjectColumns: the columns that may follow: the kind of what a
// step examined (subject::, kSubjectNames), and the kind's values besides level, i, j, k and value. Columns that a kind
// does not use are empty:
// - sphere: s, t, z are its centre;
// - cone: s, t, z are its apex, index its sector of count; width and height are 1 if it belongs to a cell;
// - voxel: width and height are its footprint in cells, count is the number of layers;
// - quad: s, t are its first corner, width and height its size, texels;
// - layer: index is its number of count;
// - texel: s, t are the ray's coordinates on its level, if the ray continues one level below.
inline constexpr std::string_view kStepColumns =
    "ray,number,phase,level,i,j,k,lambda_in,lambda_out,z_in,z_out,value,decision,lambda_after";
inline constexpr std::array<std::string_view, 8> kSubjectColumns{"kind",  "s",      "t",     "z",
                                                                 "width", "height", "index", "count"};
inline constexpr std::string_view kStepsHeader =
    "ray,number,phase,level,i,j,k,lambda_in,lambda_out,z_in,z_out,value,decision,lambda_after,"
    "kind,s,t,z,width,height,index,count";

// Parses a header and one ray per line. fileName: for messages. Throws InputError with the line's number for another
// header, a line that is not four numbers, or a number that is not finite. Blank lines are accepted only at the end.
RayBlock parseRays(std::string_view text, const std::string& fileName);
// Parses the answer to each ray. The header begins with outcome,lambda; further columns may be s, t (texels) and steps
// (a whole number), which may be empty, and others, which are ignored. Without s and t they are NaN, without steps 0.
// Throws InputError with the line for another header, wrong columns, an unknown outcome, a number that is not finite,
// and a hit whose lambda is outside [0, 1] by more than 1e-5; a smaller difference is rounding, and is clamped.
HitBlock parseHits(std::string_view text, const std::string& fileName);
// Returns true if the text begins as a file of hits does.
bool isHitsText(std::string_view text);
// Parses steps of `rays` rays, numbered from 0, in the formats written below: CSV, or JSON if the text begins with "[".
// The rays may be in any order and some may be missing; the steps of one ray must be consecutive and numbered from 1.
// phase, i, j, k, z_in, z_out and all values of the kind may be left out in JSON, the columns from `kind` on in CSV;
// columns with other names go to `further` unless it is null. Throws InputError with the line for another header, wrong
// columns, an unknown decision, phase or kind, a number that is not finite, lambda outside [0, 1] or before the
// interval's begin, heights that differ from 1 - lambda, steps out of order, and rays that the rays file does not have.
// Files contain no periods, and those of earlier versions no kinds: placeSteps() determines them.
StepLog parseSteps(std::string_view text, const std::string& fileName, std::size_t rays,
                   std::vector<FurtherColumn>* further = nullptr);
// Sets the period of each step's texel under repeat addressing, and missing kinds: in a log without any decision about
// cells, steps without a kind examine points. number: number of the ray, for messages. Throws InputError if the picture
// has no such texel.
void placeSteps(std::span<Step> steps, const ViewRay& ray, const HeightField& field, const std::string& fileName,
                std::size_t number);
// Returns the answer with which a ray's log ends; Limit if it ends without hit or miss.
Hit answerOf(std::span<const Step> steps, const ViewRay& ray);
// Returns the steps of one ray of the log.
std::span<Step> stepsOf(StepLog& log, std::size_t ray);
std::span<const Step> stepsOf(const StepLog& log, std::size_t ray);

// Returns the lines of all rays, without the header, formatted in parallel. Throws Cancelled.
std::string rayLines(const RayBlock& rays, Work& work);

// Parses one ray as on the command line, "s0,t0,a,b". Throws InputError naming the option.
ViewRay parseRayText(const std::string& text, const std::string& option);

// Returns "hit", "miss" or "limit"; "miss" for a ray that was never traced (a pixel without polygon).
std::string_view outcomeName(Outcome outcome);

// Appends the lines of hits [first, last), without the header. For miss and limit, lambda, s and t are empty.
void appendHitLines(std::string& out, const HitBlock& hits, std::size_t first, std::size_t last);
// Returns all lines, formatted in parallel; the text is the same for any number of threads. Throws Cancelled.
std::string hitLines(const HitBlock& hits, Work& work);

// Appends the steps of ray `inLog` of the log as those of ray number `ray`, numbered from 1; without the header.
void appendStepLines(std::string& out, const StepLog& log, std::size_t inLog, std::size_t ray);
// Appends the same as JSON objects with separators. empty: true if no object was written before; set to false.
void appendStepObjects(std::string& out, const StepLog& log, std::size_t inLog, std::size_t ray, bool& empty);

}  // namespace relief
