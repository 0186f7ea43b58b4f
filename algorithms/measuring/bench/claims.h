// The claims of the five papers, one per line, and what was measured for each.
//
// [MIP18], [DIST17], [PERSP], [TEX] (which repeats [ANISO17]): algorithms/notation.md. Counts of operations, steps and
// errors decide wherever possible, because they are the same on every machine. A rate is given with its spread and its
// error, and both sides of a comparison use the same implementation form. Sentences: messages.def.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "relief/messages.h"
#include "relief/work.h"

namespace relief {

// Depends: holds for part of what was measured, or only under a condition that the measurement states.
enum class ClaimVerdict : std::uint8_t { Confirmed, Refuted, Depends };

struct Claim {
    std::string_view id;     // stable key in files
    std::string_view paper;  // "[MIP18]"
    Message place;           // place in the paper
    MessageId sentence{};    // the claim
    MessageId found{};       // the measured result, with values
};
// In the order of the papers.
const std::vector<Claim>& paperClaims();

struct MeasuredClaim {
    std::string id;
    ClaimVerdict verdict{};
    std::vector<MessageValue> values;  // of the message Claim::found
};

struct ClaimsTable {
    std::string date;  // YYYY-MM-DD
    std::string cpu, compiler, commit;
    int size = 0;           // texels along each side of the reliefs
    std::int64_t rays = 0;  // per relief
    std::vector<MeasuredClaim> claims;
};

struct ClaimsOptions {
    int size = 128;             // 16 to 1024
    std::int64_t rays = 20000;  // per relief, at least 100
    int rounds = 5;             // of timed measurements
};
// Measures all claims on six procedural reliefs (seed 1), relief depth 0.2, bilinear, repeat. Takes some minutes.
// Throws Cancelled.
ClaimsTable measureClaims(const ClaimsOptions& options, Work& work);

// Returns the table that is compiled into the program.
const ClaimsTable& shippedClaims();

// Returns two lines with machine and date, then a line per claim: paper and place | sentence | measured | verdict.
std::string claimsText(const ClaimsTable& table, Language language);
// Returns a JSON object with the numbers, ending with "\n"; parseClaims() reads it back and throws InputError if the
// text is no such table.
std::string claimsJson(const ClaimsTable& table);
ClaimsTable parseClaims(const std::string& text, const std::string& fileName);

}  // namespace relief
