// SPDX-License-Identifier: MIT
// What each cause is and what would mend it.
#include "studies/measures/causes.h"

namespace inkbench {
namespace {

constexpr std::array<CauseInfo, kCauses> kTable{{
    {Cause::doubled,
     "false_doubled",
     "doubled",
     "A second line beside one that is there already, or a line too thick to thin to one.",
     "thin the lines on the nearer side: another method, or a lower sensitivity",
     {230, 159, 0}},
    {Cause::quantised,
     "false_quantised",
     "quantised",
     "It is gone with float buffers.",
     "image.precision = float",
     {204, 121, 167}},
    {Cause::seam,
     "false_seam",
     "seam",
     "The normals jump on a smooth surface, where the file's vertices are split.",
     "model.NAME.normals = smooth, or a method that reads the surface",
     {0, 114, 178}},
    {Cause::facet,
     "false_facet",
     "facet",
     "It runs along mesh edges that bend less than a crease.",
     "smooth normals, more triangles, or a larger angle",
     {86, 180, 233}},
    {Cause::grazing,
     "false_grazing",
     "grazing",
     "The depth term sees a surface's slope: the neighbours lie in the pixel's plane.",
     "edges.method = dihedral, or a test against the plane",
     {213, 94, 0}},
    {Cause::bend,
     "false_bend",
     "bend",
     "A smooth bend looks sharp at this size and is gone at twice the size.",
     "a larger image, or a less sensitive limit",
     {0, 158, 115}},
    {Cause::other_false,
     "false_other",
     "other",
     "None of these.",
     "`inkbench explain` says what the terms are",
     {90, 90, 90}},
    {Cause::displaced,
     "missed_displaced",
     "displaced",
     "A line lies near, but too far off, or it is paired with another one.",
     "place lines on the nearer side: another method",
     {240, 228, 66}},
    {Cause::same_id,
     "missed_same_id",
     "ids only",
     "Two objects touch without a step or a bend, and the detector does not look at ids.",
     "edges.method = dihedral or mitchell",
     {153, 85, 187}},
    {Cause::no_signal,
     "missed_no_signal",
     "no signal",
     "The detector sees under 1 % of its limit there.",
     "another method: no limit of this one draws it",
     {25, 25, 112}},
    {Cause::under_the_limit,
     "missed_under_the_limit",
     "under the limit",
     "The detector sees something, though less than its limit.",
     "a lower limit; `inkbench explain` says which",
     {0, 200, 220}},
    {Cause::other_missed,
     "missed_other",
     "other",
     "Detected, yet not drawn there, or drawn and paired with another line.",
     "thinner or unbroken lines",
     {170, 170, 170}},
}};

}  // namespace

std::span<const CauseInfo, kCauses> cause_table() {
  return kTable;
}

}  // namespace inkbench
