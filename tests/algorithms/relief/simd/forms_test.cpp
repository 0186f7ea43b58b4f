// Every tracer has a SIMD version, for each of its maps, or says why not.
#include <gtest/gtest.h>

#include "algorithms/relief/fields.h"
#include "relief/tracers/form_note.h"

namespace relief::test {
namespace {

TEST(Forms, everyTracerHasSimdOrSaysWhyNot) {
    for (const MethodDescription& method : tracerList()) {
        if (methodForm({method.name, {}}) == Form::Simd) continue;
        EXPECT_NE(formNote(method.name), "") << method.name;
    }
}

TEST(Forms, conesAreTracedInSimdAsFilesStoreThem) {
    MapCache cache;
    Work work(1);
    const HeightField field(randomHeights(9, 7, 3));
    for (const MethodChoice& choice :
         {MethodChoice{"cone", {{"layout", "texel"}}}, MethodChoice{"cone", {{"sectors", "4"}}},
          MethodChoice{"cone", {{"precision", "u8"}}}, MethodChoice{"cone-dummer", {{"precision", "u16"}}},
          MethodChoice{"relaxed-cone", {{"radius", "4"}}},
          MethodChoice{"hybrid", {{"inner", "cone"}, {"inner.sectors", "4"}}}}) {
        EXPECT_EQ(methodForm(choice), Form::Simd) << describe(choice);
        EXPECT_EQ(makeTracer(choice, field, cache, work)->form(), Form::Simd) << describe(choice);
        EXPECT_EQ(makeTracer(choice, field, cache, work, Form::Scalar)->form(), Form::Scalar) << describe(choice);
    }
}

TEST(Forms, hybridIsScalarWhereItsInnerMethodIs) {
    EXPECT_EQ(methodForm({"hybrid", {}}), Form::Simd);
    EXPECT_EQ(methodForm({"hybrid", {{"inner", "exact"}}}), Form::Scalar);
    EXPECT_EQ(methodForm({"hybrid", {{"inner", "cone"}}}), Form::Scalar);
}

}  // namespace
}  // namespace relief::test
