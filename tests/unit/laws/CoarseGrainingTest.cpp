// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/laws/CoarseGraining.hpp"
#include "coupling/laws/InputError.hpp"
#include "Air.hpp"

#include <gtest/gtest.h>
#include <cmath>

using namespace interstice;
using namespace interstice::test;

TEST(CoarseGraining, CountsTheGrainsOfAParcel)
{
    const CoarseGraining parcels(10);
    EXPECT_DOUBLE_EQ(parcels.grainsPerParcel(), 1000);
    EXPECT_DOUBLE_EQ(parcels.originalDiameter(400e-6), 40e-6);
}

TEST(CoarseGraining, GivesAParcelTheDragOfItsGrains)
{
    for (const double k : {1.0, 4.0, 10.0})
    {
        for (const DragLawEntry& entry : dragLaws())
        {
            const std::unique_ptr<DragLaw> law = makeDragLaw(entry.name);
            const LocalFlow grain = airAt(0.5, 0.45);
            LocalFlow parcel = grain;
            parcel.diameter = k * grain.diameter;

            const double ofGrain = CoarseGraining().parcelDragCoefficient(*law, grain);
            const double ofParcel = CoarseGraining(k).parcelDragCoefficient(*law, parcel);
            EXPECT_NEAR(ofParcel / (k * k * k * ofGrain), 1, 1e-12) << entry.name << ' ' << k;
        }
    }
}

// 3 pi mu d of Stokes, for a grain; 3 pi x 1.7894e-5 x 40e-6 = 6.74591e-9 kg/s.
TEST(CoarseGraining, LeavesAGrainAsItIs)
{
    EXPECT_NEAR(CoarseGraining(1).parcelDragCoefficient(*makeDragLaw("Stokes"), airAt(0, 1)),
        6.74591e-9, 1e-13);
}

TEST(CoarseGraining, RefusesAFactorBelowOne)
{
    EXPECT_THROW(CoarseGraining{0.5}, InputError);
    EXPECT_THROW(CoarseGraining{0}, InputError);
    EXPECT_THROW(CoarseGraining{std::nan("")}, InputError);
    EXPECT_THROW(CoarseGraining{INFINITY}, InputError);
}
