#include "embree_scene.h"

#if defined(EMBREE_VERSION) && EMBREE_VERSION == 4
#include <embree4/rtcore.h>
#elif defined(EMBREE_VERSION) && EMBREE_VERSION == 3
#include <embree3/rtcore.h>
#endif

#include <cstdint>
#include <limits>

namespace multipath {

#if defined(EMBREE_VERSION)

namespace {

/// Embree's filter function has no other way to tell anything but through memory of its user.
void refuse_and_count(const RTCFilterFunctionNArguments* arguments)
{
    ++*static_cast<std::uint64_t*>(arguments->geometryUserPtr);
    arguments->valid[0] = 0;
}

RTCRayHit ray_of(const Line& line)
{
    RTCRayHit ray{};
    ray.ray.org_x = static_cast<float>(line.origin.x);
    ray.ray.org_y = static_cast<float>(line.origin.y);
    ray.ray.org_z = static_cast<float>(line.origin.z);
    ray.ray.dir_x = static_cast<float>(line.direction.x);
    ray.ray.dir_y = static_cast<float>(line.direction.y);
    ray.ray.dir_z = static_cast<float>(line.direction.z);
    ray.ray.tfar = static_cast<float>(line.t_max);
    ray.ray.mask = ~0u;
    ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    ray.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    return ray;
}

void intersect(RTCScene scene, RTCRayHit& ray)
{
#if EMBREE_VERSION == 4
    rtcIntersect1(scene, &ray);
#else
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(scene, &context, &ray);
#endif
}

bool is_occluded(RTCScene scene, RTCRay& ray)
{
#if EMBREE_VERSION == 4
    rtcOccluded1(scene, &ray);
#else
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded1(scene, &context, &ray);
#endif
    return ray.tfar < 0.0f;
}

} // namespace

struct EmbreeScene::Handles
{
    RTCDevice device = rtcNewDevice("threads=1");
    RTCScene all_hits = rtcNewScene(device);
    RTCScene closest_hit = rtcNewScene(device);
    std::uint64_t counted = 0;

    ~Handles()
    {
        rtcReleaseScene(all_hits);
        rtcReleaseScene(closest_hit);
        rtcReleaseDevice(device);
    }

    RTCGeometry geometry(const SurfaceList& triangles) const
    {
        const RTCGeometry mesh = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
        auto* corners = static_cast<float*>(rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                                    3 * sizeof(float), 3 * triangles.size()));
        auto* numbers = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(
            mesh, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), triangles.size()));
        std::uint32_t corner = 0;
        for (const Surface& triangle : triangles)
            for (const Vec3 p :
                 {triangle.origin, triangle.origin + triangle.edge_u, triangle.origin + triangle.edge_v}) {
                *corners++ = static_cast<float>(p.x);
                *corners++ = static_cast<float>(p.y);
                *corners++ = static_cast<float>(p.z);
                *numbers++ = corner++;
            }
        return mesh;
    }

    static void commit(RTCScene scene, RTCGeometry mesh)
    {
        rtcCommitGeometry(mesh);
        rtcAttachGeometry(scene, mesh);
        rtcReleaseGeometry(mesh);
        rtcSetSceneBuildQuality(scene, RTC_BUILD_QUALITY_HIGH);
        rtcCommitScene(scene);
    }
};

bool EmbreeScene::available()
{
    return true;
}

std::string EmbreeScene::version()
{
    return "Embree " + std::to_string(EMBREE_VERSION);
}

EmbreeScene::EmbreeScene(const SurfaceList& triangles) : handles_(std::make_unique<Handles>())
{
    Handles::commit(handles_->closest_hit, handles_->geometry(triangles));
    const RTCGeometry filtered = handles_->geometry(triangles);
    rtcSetGeometryUserData(filtered, &handles_->counted);
    rtcSetGeometryIntersectFilterFunction(filtered, refuse_and_count);
    Handles::commit(handles_->all_hits, filtered);
}

EmbreeScene::~EmbreeScene() = default;

double EmbreeScene::count_all_hits(const std::vector<Line>& lines) const
{
    handles_->counted = 0;
    for (const Line& line : lines) {
        RTCRayHit ray = ray_of(line);
        intersect(handles_->all_hits, ray);
    }
    return static_cast<double>(handles_->counted);
}

double EmbreeScene::count_closest_hits(const std::vector<Line>& rays) const
{
    double count = 0.0;
    for (const Line& line : rays) {
        RTCRayHit ray = ray_of(line);
        ray.ray.tnear = 1e-5f; // its own surface would be hit otherwise
        intersect(handles_->closest_hit, ray);
        count += ray.hit.geomID != RTC_INVALID_GEOMETRY_ID ? 1.0 : 0.0;
    }
    return count;
}

double EmbreeScene::count_occluded(const std::vector<Line>& rays) const
{
    double count = 0.0;
    for (const Line& line : rays) {
        RTCRay ray = ray_of(line).ray;
        ray.tnear = 1e-5f; // its own surface and the target would be hit otherwise
        ray.tfar = 1.0f - 1e-5f;
        count += is_occluded(handles_->closest_hit, ray) ? 1.0 : 0.0;
    }
    return count;
}

#else

struct EmbreeScene::Handles
{
};

bool EmbreeScene::available()
{
    return false;
}

std::string EmbreeScene::version()
{
    return "none";
}

EmbreeScene::EmbreeScene(const SurfaceList&) {}

EmbreeScene::~EmbreeScene() = default;

double EmbreeScene::count_all_hits(const std::vector<Line>&) const
{
    return 0.0;
}

double EmbreeScene::count_closest_hits(const std::vector<Line>&) const
{
    return 0.0;
}

double EmbreeScene::count_occluded(const std::vector<Line>&) const
{
    return 0.0;
}

#endif

} // namespace multipath
