#include "itk_peer.h"

#include <algorithm>

#include <itkImage.h>
#include <itkSignedMaurerDistanceMapImageFilter.h>
#include <itkVersion.h>

namespace relief::peers {

struct ItkDistance::Impl {
    using Solid = itk::Image<unsigned char, 3>;
    using Distances = itk::Image<float, 3>;
    using Filter = itk::SignedMaurerDistanceMapImageFilter<Solid, Distances>;

    Solid::Pointer solid = Solid::New();
    Filter::Pointer filter;
    unsigned threads = 1;
};

ItkDistance::ItkDistance(const unsigned char* solid, int nx, int ny, int layers, double dz, int threads)
    : impl_(std::make_unique<Impl>()) {
    const auto n = [](int value) { return static_cast<itk::SizeValueType>(value); };
    Impl::Solid::RegionType region;
    region.SetSize({{n(nx), n(ny), n(layers + 1)}});
    impl_->solid->SetRegions(region);
    const double spacing[3] = {1, 1, dz};
    impl_->solid->SetSpacing(spacing);
    impl_->solid->Allocate();
    std::copy_n(solid, region.GetNumberOfPixels(), impl_->solid->GetBufferPointer());
    impl_->threads = static_cast<unsigned>(threads);
}

ItkDistance::~ItkDistance() = default;

void ItkDistance::build() {
    impl_->filter = Impl::Filter::New();
    impl_->filter->SetInput(impl_->solid);
    impl_->filter->SquaredDistanceOff();
    impl_->filter->UseImageSpacingOn();
    impl_->filter->SetNumberOfWorkUnits(impl_->threads);
    impl_->filter->GetMultiThreader()->SetMaximumNumberOfThreads(impl_->threads);
    impl_->filter->Update();
}

double ItkDistance::at(int x, int y, int k) const {
    const Impl::Distances::IndexType index{{x, y, k + 1}};
    return std::max(0.0, static_cast<double>(impl_->filter->GetOutput()->GetPixel(index)));
}

std::string ItkDistance::version() {
    return itk::Version::GetITKVersion();
}

}  // namespace relief::peers
