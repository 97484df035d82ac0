// The multi-path method of Castro, Martinez, Sbert (1998) in one file, to be read in an hour: an OBJ room in, Sobol's
// sequence, the extended first shot, global lines that exchange power, a picture and a table out. No threads, no tree,
// no tricks: every line is tested against every surface. Numbers in brackets are the paper's equations, labels such as
// (M1) those of docs/equations.md. The program in src/ gives the same numbers to rounding (tests/cli/mini.sh).
//
//     g++ -O2 multipath_mini.cpp -o multipath_mini
//     ./multipath_mini ../../scenes/5cubes.obj               writes mini.ppm and mini.csv
//     ./multipath_mini ROOM.obj [LINES [PASSES [PATCH_SIZE [POWER_BY_LINE]]]]
//
// PASSES: 0 casts global lines only, 1 is the paper's first shot, more the extended first shot. POWER_BY_LINE [W] is
// that of a ray of the shots; without it, (3) shares the lines.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

const double pi = 3.14159265358979323846;

// 1. Vectors, which also stand for the three colours.

// clang-format off
struct Vec { double x = 0, y = 0, z = 0; };
Vec operator+(Vec a, Vec b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Vec operator-(Vec a, Vec b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Vec operator*(double s, Vec a) { return {s * a.x, s * a.y, s * a.z}; }
Vec operator*(Vec a, Vec b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
double dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Vec cross(Vec a, Vec b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
double length(Vec a) { return std::sqrt(dot(a, a)); }
Vec unit(Vec a) { return (1 / length(a)) * a; }
double mean(Vec a) { return (a.x + a.y + a.z) / 3; }
// clang-format on

// 2. The scene: surfaces, each cut into a grid of patches.

// The points origin + u edge_u + v edge_v. Its front is where the corners run counter-clockwise.
struct Surface
{
    Vec origin, edge_u, edge_v, normal; // normal: cross(edge_u, edge_v), as long as the area of the parallelogram
    bool triangle;
    int nu, nv, first_patch; // patches along both edges; those of a triangle are nu * nu
    Vec at(double u, double v) const { return origin + u * edge_u + v * edge_v; }
    int patch_at(double u, double v) const
    {
        const int i = std::clamp(int(u * nu), 0, nu - 1);
        if (!triangle)
            return first_patch + i * nv + std::clamp(int(v * nv), 0, nv - 1);
        const int last = nu - 1 - i, j = std::clamp(int(v * nu), 0, last); // column i holds 2 (nu - i) - 1 patches
        const bool upper = j < last && (u * nu - i) + (v * nu - j) > 1;
        return first_patch + i * (2 * nu - i) + 2 * j + upper;
    }
};

struct Patch
{
    int surface;
    double area;
    Vec origin, edge_u, edge_v;
    Vec reflectance, emittance; // rho [1], E [W/m^2]
    Vec unshot, arrived;        // [W]
    Vec forecast, held;         // [W] of the global pass
};

std::vector<Surface> surfaces;
std::vector<Patch> patches;
Vec low = {1e300, 1e300, 1e300}, high = {-1e300, -1e300, -1e300}; // bounding box

void add_surface(const std::vector<Vec>& corners, double patch_size, Vec reflectance, Vec emittance)
{
    Surface s = {corners[0], corners[1] - corners[0], corners.back() - corners[0], {}, corners.size() == 3, 0, 0, 0};
    s.normal = cross(s.edge_u, s.edge_v);
    const auto cells = [&](double edge) { return std::max(1, int(std::ceil(edge / patch_size - 1e-6))); };
    s.nu = cells(length(s.edge_u)), s.nv = cells(length(s.edge_v));
    if (s.triangle)
        s.nu = s.nv = std::max({s.nu, s.nv, cells(length(s.edge_u - s.edge_v))});
    s.first_patch = int(patches.size());
    const Vec a = (1.0 / s.nu) * s.edge_u, b = (1.0 / s.nv) * s.edge_v;
    const auto add = [&](Vec origin, double turned) { // turned: -1 for the triangles that are upside down
        const double area = length(s.normal) / (s.triangle ? 2 : 1) / s.nu / s.nv;
        const Vec none;
        patches.push_back({int(surfaces.size()), area, origin, turned * a, turned * b, reflectance, emittance,
                           area * emittance, none, none, none});
    };
    for (int i = 0; i < s.nu; ++i)
        for (int j = 0; j < (s.triangle ? s.nu - i : s.nv); ++j) {
            add(s.origin + double(i) * a + double(j) * b, 1);
            if (s.triangle && j < s.nu - i - 1)
                add(s.origin + (i + 1.0) * a + (j + 1.0) * b, -1);
        }
    surfaces.push_back(s);
    for (const Vec p : corners) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
}

// The faces of an OBJ file, as parallelograms or triangles, and Kd and Ke of its material file.
void read_obj(const std::string& path, double patch_size)
{
    std::map<std::string, std::array<Vec, 2>> materials; // Kd, Ke
    std::vector<Vec> points;
    std::string line, word, material, folder = path.substr(0, path.find_last_of('/') + 1);
    std::ifstream file(path);
    if (!file)
        std::cerr << path << ": cannot be opened\n", std::exit(1);
    while (std::getline(file, line)) {
        std::istringstream in(line);
        Vec v;
        in >> word;
        if (!in)
            continue;
        if (word == "mtllib" && in >> word) {
            std::ifstream mtl(folder + word);
            while (std::getline(mtl, line)) {
                std::istringstream entry(line);
                if (entry >> word && word == "newmtl")
                    entry >> material;
                else if (entry && (word == "Kd" || word == "Ke") && entry >> v.x >> v.y >> v.z)
                    materials[material][word == "Ke"] = v;
            }
        } else if (word == "v" && in >> v.x >> v.y >> v.z) {
            points.push_back(v);
        } else if (word == "usemtl") {
            in >> material;
        } else if (word == "f") {
            std::vector<Vec> corners;
            while (in >> word) { // 7, 7/1, 7//2, 7/1/2, or -1 for the last point so far
                const long k = std::stol(word);
                corners.push_back(points.at(std::size_t(k < 0 ? long(points.size()) + k : k - 1)));
            }
            const auto add = [&](const std::vector<Vec>& face) {
                add_surface(face, patch_size, materials[material][0], materials[material][1]);
            };
            const bool parallelogram =
                corners.size() == 4 &&
                length(corners[0] + corners[2] - corners[1] - corners[3]) < 1e-9 * length(corners[2] - corners[0]);
            if (parallelogram)
                add(corners);
            for (std::size_t k = 2; !parallelogram && k < corners.size(); ++k) // convex ones
                add({corners[0], corners[k - 1], corners[k]});
        }
    }
}

// 3. What lines meet.

struct Hit
{
    double t;
    int patch;
    bool front; // the line arrives at the front; otherwise it comes from behind and leaves the front
};

// Where surfaces touch, a line leaves one before it arrives at the other: there is a gap between them, without a width.
const double gap = 1e-10;

bool meets(const Surface& s, Vec from, Vec direction, double t_min, double t_max, Hit& hit)
{
    const double approach = dot(s.normal, direction);
    if (approach == 0)
        return false;
    hit.front = approach < 0;
    hit.t = dot(s.normal, s.origin - from) / approach - (hit.front ? 0 : gap);
    if (!(hit.t > (hit.front ? t_min - 0.5 * gap : t_min)) || hit.t > t_max)
        return false;
    const Vec p = from + hit.t * direction - s.origin;
    const double u = dot(cross(p, s.edge_v), s.normal) / dot(s.normal, s.normal);
    const double v = dot(cross(s.edge_u, p), s.normal) / dot(s.normal, s.normal);
    if (u < 0 || v < 0 || u > 1 || v > 1 || (s.triangle && u + v > 1))
        return false;
    hit.patch = s.patch_at(u, v);
    return true;
}

// 4. Numbers: Sobol's sequence in four dimensions, one item for each line (section 3).

std::array<double, 4> sobol(std::uint64_t n)
{
    // Primitive polynomials and starting numbers of Numerical Recipes in C, 2nd edition, 7.7.
    static const int degree[4] = {1, 2, 3, 3}, inner[4] = {0, 1, 1, 2};
    static const std::uint64_t start[4][3] = {{1}, {1, 1}, {1, 3, 7}, {1, 3, 3}};
    static std::uint64_t direction[4][52];
    static const bool ready = [] {
        for (int d = 0; d < 4; ++d)
            for (int j = 0; j < 52; ++j) {
                std::uint64_t& v = direction[d][j];
                if (j < degree[d]) {
                    v = start[d][j] << (63 - j);
                    continue;
                }
                v = direction[d][j - degree[d]] ^ direction[d][j - degree[d]] >> degree[d];
                for (int k = 1; k < degree[d]; ++k)
                    if (inner[d] >> (degree[d] - 1 - k) & 1)
                        v ^= direction[d][j - k];
            }
        return true;
    }();
    std::array<double, 4> item = {};
    for (int d = 0; ready && d < 4; ++d) {
        std::uint64_t x = 0;
        int bit = 0;
        for (std::uint64_t gray = n ^ n >> 1; gray != 0; gray >>= 1, ++bit) // Antonov and Saleev
            x ^= gray & 1 ? direction[d][bit] : 0;
        item[std::size_t(d)] = double(x >> 12) / 4503599627370496.0; // 2^52
    }
    return item;
}

// A number of [0, 1) that looks random, for each pass: SplitMix64's finaliser.
double random_of_pass(std::uint64_t pass)
{
    const auto mix = [](std::uint64_t x) {
        x = (x ^ x >> 30) * 0xbf58476d1ce4e5b9u;
        x = (x ^ x >> 27) * 0x94d049bb133111ebu;
        return x ^ x >> 31;
    };
    return double(mix(mix(1 ^ 0x5be0cd19137e2179u) + 0x9e3779b97f4a7c15u * (pass + 1)) >> 12) / 4503599627370496.0;
}

Vec on_sphere(double a, double b) // uniform: z is uniform (Archimedes)
{
    const double r = 2 * std::sqrt(a * (1 - a));
    return {r * std::cos(2 * pi * b), r * std::sin(2 * pi * b), 1 - 2 * a};
}

// 5. The extended first shot: rays from patches (section 4.1).

std::uint64_t next_item = 0; // of the sequence

double share_above(const Patch& p, double threshold) // of its unshot power
{
    const double radiosity = mean(p.unshot) / p.area;
    return radiosity > threshold && radiosity > 0 ? 1 - threshold / radiosity : 0;
}

// A ray from a uniform point of the patch, in a cosine-distributed direction; the patch where it arrives, or -1.
int shoot_ray(const Patch& p, const std::array<double, 4>& item)
{
    const Surface& s = surfaces[std::size_t(p.surface)];
    double u = std::clamp(item[0], 0x1p-30, 1 - 0x1p-30), v = std::clamp(item[1], 0x1p-30, 1 - 0x1p-30);
    if (s.triangle) {
        const double width = std::sqrt(1 - u);
        u = 1 - width, v *= width;
    }
    const Vec from = p.origin + u * p.edge_u + v * p.edge_v;
    const Vec z = unit(s.normal), e = unit(p.edge_u); // axes oblique to the edges: even numbers must not aim at edges
    const Vec x = 0.6 * e + 0.8 * cross(z, e), y = cross(z, x);
    const double r = std::sqrt(item[2]), angle = 2 * pi * item[3];
    const Vec direction = r * std::cos(angle) * x + r * std::sin(angle) * y + std::sqrt(1 - item[2]) * z;
    Hit nearest = {1e300, -1, false};
    for (const Surface& other : surfaces) {
        Hit hit;
        if (&other != &s && meets(other, from, direction, 0, nearest.t, hit))
            nearest = hit;
    }
    return nearest.front ? nearest.patch : -1;
}

// One pass of the pseudocode. Returns the number of rays.
std::uint64_t shoot_pass(int pass, double threshold, double power_by_line)
{
    struct Shot
    {
        std::size_t patch;
        std::uint64_t rays;
        Vec power;
    };
    std::vector<Shot> shots;
    Vec excess, sent;
    // Sources worth less than a ray get one by chance. Where there are none, the first pass is the same for every seed.
    const bool by_chance = pass > 0 || std::any_of(patches.begin(), patches.end(), [&](const Patch& p) {
                               const double power = share_above(p, threshold) * mean(p.unshot);
                               return power > 0 && power < power_by_line;
                           });
    double wanted = by_chance ? random_of_pass(std::uint64_t(pass)) : 0.5; // rays so far, rounded down patch by patch
    for (std::size_t i = 0; i < patches.size(); ++i) {
        const double share = share_above(patches[i], threshold);
        const double deserved = share * mean(patches[i].unshot) / power_by_line;
        const double before = std::floor(wanted);
        const auto rays = std::uint64_t(std::floor(wanted += deserved) - before);
        excess = excess + share * patches[i].unshot;
        if (rays > 0) {
            shots.push_back({i, rays, (share / (deserved < 1 ? deserved : double(rays))) * patches[i].unshot});
            sent = sent + double(rays) * shots.back().power;
        }
    }
    if (shots.empty())
        return 0;
    const auto factor = [](double all, double rounded) { return rounded > 0 ? std::min(2.0, all / rounded) : 1; };
    const Vec correction = {factor(excess.x, sent.x), factor(excess.y, sent.y), factor(excess.z, sent.z)};
    for (Patch& p : patches)
        p.unshot = p.unshot - share_above(p, threshold) * p.unshot;
    std::uint64_t count = 0;
    for (const Shot& shot : shots)
        for (std::uint64_t k = 0; k < shot.rays; ++k, ++count) {
            const int j = shoot_ray(patches[shot.patch], sobol(next_item++));
            if (j < 0)
                continue;
            Patch& to = patches[std::size_t(j)];
            to.arrived = to.arrived + correction * shot.power;
            to.unshot = to.unshot + to.reflectance * (correction * shot.power); // (S1)
        }
    return count;
}

// 6. The multi-path pass: global lines (section 2.1).

Vec turned(Vec p) // poles and meridians point nowhere in particular: a turn about (1, 2, 3) with the cosine 2/7
{
    const Vec axis = unit({1, 2, 3});
    return (2.0 / 7) * p + std::sqrt(45.0) / 7 * cross(axis, p) + 5.0 / 7 * dot(axis, p) * axis;
}

double box_area()
{
    const Vec size = high - low;
    return 2 * (size.x * size.y + size.y * size.z + size.z * size.x);
}

void cast_global_lines(std::uint64_t lines)
{
    const Vec centre = 0.5 * (low + high);
    const double radius = 0.5 * length(high - low), sphere = 4 * pi * radius * radius;
    const auto cast = std::uint64_t(std::llround(double(lines) * sphere / box_area())); // (N1): `lines` meet the box
    for (Patch& p : patches) {
        const double crossings = 2 * p.area / sphere * double(cast); // (G1), a theorem of integral geometry
        p.forecast = 1 / crossings * p.unshot;                       // (G3)
        p.held = {};
    }
    std::vector<Hit> hits;
    for (std::uint64_t n = 0; n < cast; ++n) {
        const std::array<double, 4> item = sobol(next_item++);
        const Vec from = centre + radius * turned(on_sphere(item[0], item[1]));
        const Vec to = centre + radius * turned(on_sphere(item[2], item[3]));
        hits.clear();
        for (const Surface& s : surfaces) {
            Hit hit;
            if (meets(s, from, to - from, 0, 1, hit))
                hits.push_back(hit);
        }
        std::sort(hits.begin(), hits.end(), [](const Hit& a, const Hit& b) { return a.t < b.t; });
        for (std::size_t k = 0; k <= hits.size(); ++k) { // each stretch between two hits, and those before and after
            Patch* a = k > 0 && !hits[k - 1].front ? &patches[std::size_t(hits[k - 1].patch)] : nullptr;
            Patch* b = k < hits.size() && hits[k].front ? &patches[std::size_t(hits[k].patch)] : nullptr;
            const Vec from_a = a ? a->forecast + a->held : Vec(), from_b = b ? b->forecast + b->held : Vec();
            if (a)
                a->held = a->reflectance * from_b, a->arrived = a->arrived + from_b; // (M2)
            if (b)
                b->held = b->reflectance * from_a, b->arrived = b->arrived + from_a; // (M1)
        }
    }
    for (Patch& p : patches)
        p.unshot = p.held;
}

// 7. Shots and walk share the lines.

// N_l / N_g, local lines for each global line (3), after a trial of the shots. In an extended first shot every patch
// has a share: f = 1, and R_s' is the average. After a plain one, f and R_s' are those of the patches that light has
// met.
double optimal_ratio(bool extended, double average)
{
    double area = 0, lit = 0, arrived = 0, reflected = 0;
    for (const Patch& p : patches) {
        area += p.area, lit += mean(p.arrived) > 0 ? p.area : 0;
        arrived += mean(p.arrived), reflected += mean(p.reflectance) * mean(p.arrived);
    }
    if (!(reflected > 0))
        return 1;                           // nothing to share
    const double n = 2 * area / box_area(); // (G2) of lines that meet the box, as if the room filled it
    const double f = extended ? 1 : lit / area, secondary = extended ? average : reflected / arrived;
    return std::sqrt(n * (1 - average * average) * (1 - average) /
                     (secondary * secondary * (1 - average) / f + 2 * secondary * secondary * secondary));
}

// 8. Results.

Vec radiosity(const Patch& p)
{
    return p.emittance + (1 / p.area) * (p.reflectance * p.arrived); // B = E + rho H
}

// The room from outside: surfaces are seen from their front only, so that its near walls do not hide it.
void write_picture(const char* path, double white)
{
    const int width = 640, height = 480;
    const Vec centre = 0.5 * (low + high), eye = centre + length(high - low) * Vec{0.3, 0.5, 1.2};
    const Vec ahead = unit(centre - eye), right = unit(cross(ahead, {0, 1, 0})), up = cross(right, ahead);
    std::ofstream file(path, std::ios::binary);
    file << "P6\n" << width << " " << height << "\n255\n";
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const Vec direction = ahead + (x + 0.5 - width / 2) / 800.0 * right + (height / 2 - y - 0.5) / 800.0 * up;
            Hit nearest = {1e300, -1, true};
            for (const Surface& s : surfaces) {
                Hit hit;
                if (meets(s, eye, direction, 0, nearest.t, hit) && hit.front)
                    nearest = hit;
            }
            const Vec b = nearest.patch < 0 ? Vec() : (1 / white) * radiosity(patches[std::size_t(nearest.patch)]);
            for (const double c : {b.x, b.y, b.z})
                file.put(char(int(255 * std::pow(std::min(c, 1.0), 1 / 2.2))));
        }
}

int main(int count, char** words)
{
    const auto number = [&](int k, double otherwise) { return count > k ? std::atof(words[k]) : otherwise; };
    if (count < 2)
        return std::fprintf(stderr, "usage: %s ROOM.obj [LINES [PASSES [PATCH_SIZE [POWER_BY_LINE]]]]\n", words[0]), 1;
    const auto lines = std::uint64_t(number(2, 1e6));
    const int passes = int(number(3, 1000));
    read_obj(words[1], number(4, 0.15));

    double area = 0, reflecting = 0, power = 0; // A_T, A_T R_ave, Phi_T
    for (const Patch& p : patches)
        area += p.area, reflecting += p.area * mean(p.reflectance), power += p.area * mean(p.emittance);
    if (!(power > 0))
        return std::fprintf(stderr, "%s: no patch emits light\n", words[1]), 1;
    const double average = reflecting / area;
    const double threshold = average * power / (area * (1 - average)); // (4)

    std::uint64_t local_lines = 0, global_lines = 0;
    int done = 0;
    const auto shoot = [&](double power_by_line) {
        local_lines = next_item = 0;
        for (done = 0; done < passes; ++done, local_lines = next_item)
            if (shoot_pass(done, threshold, power_by_line) == 0)
                break;
    };
    double power_by_line = number(5, 0);
    if (passes > 0 && power_by_line == 0) { // chosen so that shots and walk share the lines by (3)
        // How many rays a PowerByLine takes is not known beforehand. A trial with few rays tells: it is then forgotten.
        const std::vector<Patch> before = patches;
        const double trial = power / (double(lines) / 16);
        shoot(trial);
        const double ratio = optimal_ratio(passes > 1, average);
        power_by_line = trial * std::max(1.0, double(local_lines)) / (double(lines) * ratio / (1 + ratio));
        patches = before;
    }
    shoot(power_by_line);
    if (local_lines < lines)
        cast_global_lines(global_lines = lines - local_lines);
    else
        std::fprintf(stderr, "no lines are left for the walk; expected more lines, or more power by line\n");

    double light = 0, unshot = 0;
    std::ofstream table("mini.csv");
    table.precision(17);
    table << "patch,area,radiosity_r,radiosity_g,radiosity_b\n";
    for (std::size_t i = 0; i < patches.size(); ++i) {
        const Vec b = radiosity(patches[i]);
        light += patches[i].area * mean(b), unshot += mean(patches[i].unshot);
        table << i << ',' << patches[i].area << ',' << b.x << ',' << b.y << ',' << b.z << '\n';
    }
    write_picture("mini.ppm", 3 * light / area);
    std::printf("%zu surfaces, %zu patches; %llu rays of %.17g W in %d passes, %llu global lines\n", surfaces.size(),
                patches.size(), static_cast<unsigned long long>(local_lines), power_by_line, done,
                static_cast<unsigned long long>(global_lines));
    std::printf("mean radiosity %.6g W/m^2; %.3g W of %.6g W stay unshot\n", light / area, unshot, power);
}
