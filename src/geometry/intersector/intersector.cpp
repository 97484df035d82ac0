#include "geometry/intersector/intersector.h"

#include "geometry/intersector/core.h"
#include "geometry/intersector/kernel.h"

namespace multipath {

HitLists::HitLists() : scratch_(std::make_unique<Scratch>()) {}

HitLists::HitLists(const HitLists& other) : hits_(other.hits_), end_(other.end_), scratch_(std::make_unique<Scratch>())
{
}

HitLists& HitLists::operator=(const HitLists& other)
{
    hits_ = other.hits_;
    end_ = other.end_;
    return *this;
}

HitLists::~HitLists() = default;

FirstHits::FirstHits() : scratch_(std::make_unique<Scratch>()) {}

FirstHits::FirstHits(const FirstHits& other)
    : hits_(other.hits_), is_hit_(other.is_hit_), scratch_(std::make_unique<Scratch>())
{
}

FirstHits& FirstHits::operator=(const FirstHits& other)
{
    hits_ = other.hits_;
    is_hit_ = other.is_hit_;
    return *this;
}

FirstHits::~FirstHits() = default;

Intersector::Intersector(const SurfaceList& surfaces, int threads)
    : Intersector(surfaces, *available_kernels()[0], threads)
{
}

Intersector::Intersector(const SurfaceList& surfaces, const FilterKernel& kernel, int threads)
    : core_(std::make_unique<const IntersectorCore>(surfaces, kernel, threads))
{
}

Intersector::~Intersector() = default;
Intersector::Intersector(Intersector&&) noexcept = default;
Intersector& Intersector::operator=(Intersector&&) noexcept = default;

void Intersector::all_hits(const Line& line, std::vector<Hit>& hits) const
{
    core_->all_hits(line, hits);
}

void Intersector::all_hits(const Line* lines, std::size_t count, HitLists& lists) const
{
    core_->all_hits(lines, count, lists);
}

std::optional<Hit> Intersector::closest_hit(const Line& line) const
{
    return core_->closest_hit(line);
}

std::optional<Hit> Intersector::closest_hit_from(std::uint32_t from, const Line& ray) const
{
    return core_->closest_hit_from(from, ray);
}

void Intersector::closest_hits_from(const std::uint32_t* from, const Line* rays, std::size_t count,
                                    FirstHits& found) const
{
    core_->closest_hits_from(from, rays, count, found);
}

std::vector<std::uint32_t> Intersector::coincident_surfaces(std::uint32_t of, Vec3 point) const
{
    return core_->coincident_surfaces(of, point);
}

std::size_t Intersector::surfaces_around(std::uint32_t of, Vec3 point) const
{
    return core_->surfaces_around(of, point);
}

std::optional<std::vector<std::uint32_t>> Intersector::surfaces_near(const Bounds& box) const
{
    return core_->surfaces_near(box);
}

bool Intersector::meets(const Line& line, std::uint32_t surface) const
{
    return core_->meets(line, surface);
}

bool Intersector::is_over(std::uint32_t a, std::uint32_t b) const
{
    return core_->is_over(a, b);
}

} // namespace multipath
