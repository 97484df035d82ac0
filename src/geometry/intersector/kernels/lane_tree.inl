// Searches in the hierarchy, vectorised over the children of a node and the surfaces of a leaf. Included after
// lane_packet.inl, once for each instruction set.
//
// Many lines are searched at once, in rounds. In a round each line visits one child: all nodes are tested first, then
// all leaves, then all candidates are decided. Within a step the lines are independent, so that the processor works on
// some of them while others wait for memory. There are nearly no branches on what a line meets, which cannot be
// predicted (compare Barringer, Akenine-Möller: Dynamic ray stream traversal, 2014).

namespace multipath {
namespace LANE_SET {
namespace {

/// TreeLine::inverse and at_zero of the lines of a batch.
struct Inverses
{
    alignas(64) float inverse[3][LineBatch::most];
    float at_zero[3][LineBatch::most];
};

/// Computes the inverses of the first `count` lines, and of more lines up to a multiple of the vector width.
KERNEL_CODE void find_inverses(const LineBatch& batch, std::size_t count, Inverses& result)
{
    for (unsigned axis = 0; axis < 3; ++axis)
        for (std::size_t i = 0; i < count; i += Lanes::width) {
            const Lanes d = Lanes::load(batch.direction[axis] + i);
            const Lanes least = Lanes::load(batch.scale + i) * Lanes::all(1e-12f);
            const Lanes inverse = quotient(Lanes::all(1.0f), with_sign_of(d, larger(absolute(d), least)));
            inverse.store(result.inverse[axis] + i);
            (Lanes::all(0.0f) - Lanes::load(batch.middle[axis] + i) * inverse).store(result.at_zero[axis] + i);
        }
}

/// Prepares a line for the search. Branch-free: the signs of directions are hard to predict.
KERNEL_CODE void fill_line(const LineBatch& batch, const Inverses& inverses, std::uint32_t number, TreeLine& line)
{
    for (unsigned axis = 0; axis < 3; ++axis) {
        const float d = batch.direction[axis][number];
        std::uint32_t bits_of_d = 0;
        std::memcpy(&bits_of_d, &d, sizeof d);
        const std::uint32_t to_high = WideNode::high(0) * (bits_of_d >> 31);
        line.inverse[axis] = inverses.inverse[axis][number];
        line.at_zero[axis] = inverses.at_zero[axis][number];
        line.near_plane[axis] = WideNode::low(axis) + to_high;
        line.far_plane[axis] = WideNode::high(axis) - to_high;
        line.direction[axis] = d;
        line.middle[axis] = batch.middle[axis][number];
    }
    line.scale = batch.scale[number];
    line.first = -batch.half_length[number];
    line.last = batch.half_length[number];
    line.number = number;
}

KERNEL_ENTRY void fill_tree_lines(const LineBatch& batch, const std::uint32_t* numbers, std::size_t count,
                                  TreeLine* lines)
{
    if (count == 0)
        return;
    Inverses inverses;
    find_inverses(batch, numbers[count - 1] + std::size_t{1}, inverses);
    for (std::size_t i = 0; i < count; ++i)
        fill_line(batch, inverses, numbers[i], lines[i]);
}

/// Coordinates of the planes at an offset of WideNode::plane, for the children from `lane` on.
KERNEL_CODE Lanes planes_at(const WideNode& node, std::uint32_t plane, unsigned lane)
{
    return Lanes::load(node.plane + plane + lane);
}

/// Bits of the children whose boxes the line meets in the interval that is searched (slab test). Writes entry[i], the
/// distance in t from the beginning of the interval to box i, for all children.
KERNEL_CODE unsigned boxes_met(const WideNode& node, const TreeLine& line, float* entry)
{
    const LaneVector inverse = spread(line.inverse);
    const LaneVector at_zero = spread(line.at_zero);
    const Lanes first = Lanes::all(line.first);
    const Lanes last = Lanes::all(line.last);
    unsigned met = 0;
    for (unsigned lane = 0; lane < WideNode::lanes; lane += Lanes::width) {
        const Lanes in_x = multiply_add(planes_at(node, line.near_plane[0], lane), inverse.x, at_zero.x);
        const Lanes in_y = multiply_add(planes_at(node, line.near_plane[1], lane), inverse.y, at_zero.y);
        const Lanes in_z = multiply_add(planes_at(node, line.near_plane[2], lane), inverse.z, at_zero.z);
        const Lanes out_x = multiply_add(planes_at(node, line.far_plane[0], lane), inverse.x, at_zero.x);
        const Lanes out_y = multiply_add(planes_at(node, line.far_plane[1], lane), inverse.y, at_zero.y);
        const Lanes out_z = multiply_add(planes_at(node, line.far_plane[2], lane), inverse.z, at_zero.z);
        const Lanes in = larger(larger(in_x, in_y), larger(in_z, first));
        const Lanes out = smaller(smaller(out_x, out_y), smaller(out_z, last));
        (in - first).store(entry + lane);
        met |= bits(not_above(in, out)) << lane;
    }
    return met;
}

/// Bits of the surfaces of a leaf that a line may meet in the interval that is searched, and of those that it certainly
/// meets there, farther from its start than any surface in a plane around it.
struct LeafTest
{
    unsigned met = 0;
    unsigned certain = 0;
};

/// The tests of a block, without the surfaces `except`. If `with_certain` is false, `certain` stays 0.
template <bool with_certain, class... Surfaces>
KERNEL_CODE LeafTest test_leaf(const SurfaceBlock& leaf, const TreeLine& line, Surfaces... except)
{
    const LaneVector direction = spread(line.direction);
    const LaneVector middle = spread(line.middle);
    const Lanes first = Lanes::all(line.first);
    const Lanes last = Lanes::all(line.last);
    LeafTest result;
    for (unsigned lane = 0; lane < SurfaceBlock::lanes; lane += Lanes::width) {
        const PlaneCrossing crossing = cross_plane({load_columns(leaf.corner, lane), load_columns(leaf.edge_u, lane),
                                                    load_columns(leaf.edge_v, lane), Lanes::load(leaf.slack + lane)},
                                                   middle, direction, Lanes::all(line.scale));
        LaneMask met = crossing.may_meet(first, last);
        ((met = different(met, leaf.surface + lane, except)), ...);
        result.met |= bits(met) << lane;
        if constexpr (with_certain)
            result.certain |= bits(crossing.certainly_meets(first, last)) << lane;
    }
    return result;
}

/// Index of the lowest lane that is set; 0 if none is.
KERNEL_CODE unsigned first_lane(unsigned lanes)
{
    return static_cast<unsigned>(__builtin_ctz(lanes | 1u << 16)) & 15u;
}

/// 1 if any lane is set, else 0; written so that compilers do not generate a branch.
KERNEL_CODE std::uint32_t some(unsigned lanes)
{
    return (lanes + 0xffffu) >> 16;
}

/// Writes make(lane) to `list` for each lane that is set and returns the number of these lanes. The first two elements
/// are written without a branch, because most lines meet two or fewer: there must be room for two in any case.
template <class Element, class Make>
KERNEL_CODE std::size_t add_lanes(unsigned lanes, Element* list, const Make& make)
{
    const unsigned others = lanes & (lanes - 1);
    list[0] = make(first_lane(lanes));
    list[1] = make(first_lane(others));
    std::size_t count = some(lanes) + some(others);
    for (unsigned rest = others & (others - 1); __builtin_expect(rest != 0, 0); rest &= rest - 1)
        list[count++] = make(first_lane(rest));
    return count;
}

/// Rounds of the search for candidates. The pending children form a stack.
KERNEL_ENTRY void find_candidates(const TreeView& tree, CandidateSearch& search)
{
    constexpr std::size_t at_once = CandidateSearch::at_once;
    LineNode nodes[at_once];
    LineNode leaves[at_once];
    alignas(64) float entry[WideNode::lanes];
    while (search.pending_count > 0 && search.has_room()) {
        const std::size_t taken = search.pending_count < at_once ? search.pending_count : at_once;
        std::size_t node_count = 0;
        std::size_t leaf_count = 0;
        for (std::size_t i = 0; i < taken; ++i) { // branch-free: store to both lists, advance one
            const LineNode next = search.pending[--search.pending_count];
            nodes[node_count] = next;
            leaves[leaf_count] = {next.line, next.child & ~WideNode::leaf_flag};
            const std::size_t is_leaf = next.child / WideNode::leaf_flag;
            node_count += 1 - is_leaf;
            leaf_count += is_leaf;
        }
        for (std::size_t i = 0; i < node_count; ++i) {
            const std::uint32_t line = nodes[i].line;
            const WideNode& node = tree.nodes[nodes[i].child];
            const unsigned met = boxes_met(node, search.lines[line], entry);
            search.pending_count += add_lanes(met, search.pending + search.pending_count, [&](unsigned lane) {
                return LineNode{line, node.child[lane]};
            });
        }
        for (std::size_t i = 0; i < leaf_count; ++i) {
            const TreeLine& line = search.lines[leaves[i].line];
            const SurfaceBlock& leaf = tree.leaves[leaves[i].child];
            const unsigned met = test_leaf<false>(leaf, line).met;
            search.candidate_count += add_lanes(met, search.candidates + search.candidate_count, [&](unsigned lane) {
                return LineCandidate{line.number, leaf.surface[lane]};
            });
        }
    }
}

/// A child and the distance at which the line enters the box of the child, packed so that integers compare like the
/// distances. They do, because `entry` is not negative.
KERNEL_CODE std::uint64_t pending_child(float entry, std::uint32_t child)
{
    std::uint32_t bits_of_entry = 0;
    std::memcpy(&bits_of_entry, &entry, sizeof bits_of_entry);
    return std::uint64_t{bits_of_entry} << 32 | child;
}

/// The distance packed in a pending child.
KERNEL_CODE float entry_of(std::uint64_t pending)
{
    const auto bits_of_entry = static_cast<std::uint32_t>(pending >> 32);
    float entry = 0.0f;
    std::memcpy(&entry, &bits_of_entry, sizeof entry);
    return entry;
}

/// State of a ray during the search, with the stack of its pending children.
struct alignas(64) ActiveRay
{
    TreeLine line;
    std::uint32_t next;    ///< index of the node or leaf to visit
    std::uint32_t pending; ///< number of children on the stack
    std::uint64_t* stack;
    double excluded_plane;
    std::uint32_t from;
    std::uint32_t known; ///< surface of the hit known at the start
};

/// Starts the search of a ray. The interval searched ends at the hit already known, if there is one.
KERNEL_CODE void start_ray(const FirstHitSearch& search, const Inverses& inverses, const SearchedRay& next,
                           ActiveRay& ray)
{
    fill_line(search.batch, inverses, next.number, ray.line);
    const double distance = search.nearest[next.number].best.t - search.batch.middle_t[next.number];
    const auto limit = static_cast<float>(distance);
    ray.line.last = limit < ray.line.last ? limit : ray.line.last;
    ray.excluded_plane = next.excluded_plane;
    ray.from = next.from;
    ray.known = search.nearest[next.number].best.surface;
    ray.next = 0; // the root
    ray.pending = 0;
}

/// Returns the nearest of the children that were met and pushes the others on the stack of the ray, if `sorted` the
/// farthest first. If none was met, the result has no meaning.
KERNEL_CODE std::uint64_t take_nearest(unsigned met, const WideNode& node, const float* entry, bool sorted,
                                       ActiveRay& ray)
{
    const unsigned others = met & (met - 1);
    const unsigned one = first_lane(met);
    const unsigned two = first_lane(others);
    const std::uint64_t none = std::uint64_t{some(others)} - 1; // all bits set if there is no second child
    const std::uint64_t a = pending_child(entry[one], node.child[one]);
    const std::uint64_t b = pending_child(entry[two], node.child[two]) | none;
    std::uint64_t nearest = a < b ? a : b;
    std::uint64_t* const top = ray.stack + ray.pending;
    top[0] = a < b ? b : a;
    std::uint32_t count = some(others);
    for (unsigned rest = others & (others - 1); __builtin_expect(rest != 0, 0); rest &= rest - 1) {
        const unsigned lane = first_lane(rest);
        std::uint64_t next = pending_child(entry[lane], node.child[lane]);
        const std::uint64_t nearer = next < nearest ? next : nearest;
        next = next < nearest ? nearest : next;
        nearest = nearer;
        std::uint32_t slot = count++;
        for (; sorted && slot > 0 && top[slot - 1] < next; --slot)
            top[slot] = top[slot - 1];
        top[slot] = next;
    }
    ray.pending += count;
    return nearest;
}

/// Updates the first hit of a ray and shortens the interval searched. Ends the search of the ray if `hit` is nearer
/// than the hit known before and FirstHitSearch::any is true.
KERNEL_CODE void take_hit(const FirstHitSearch& search, const Hit& hit, ActiveRay& ray)
{
    const std::uint32_t number = ray.line.number;
    NearestHit& nearest = search.nearest[number];
    if (hit.t > nearest.best.t)
        return;
    if (hit.t == nearest.best.t) {
        search.take_coincident(search.context, nearest, hit);
        return;
    }
    nearest.best = hit;
    nearest.has_back = false;
    const auto limit = static_cast<float>(hit.t - search.batch.middle_t[number]);
    ray.line.last = limit < ray.line.last ? limit : ray.line.last;
    ray.pending = search.any ? 0 : ray.pending;
}

/// Ends the search of a ray that certainly meets this surface before the hit known before.
KERNEL_CODE void block(const FirstHitSearch& search, std::uint32_t surface, ActiveRay& ray)
{
    NearestHit& nearest = search.nearest[ray.line.number];
    nearest.best.surface = surface;
    nearest.has_back = false;
    ray.pending = 0;
}

/// A ray and a surface that it may meet.
struct RayCandidate
{
    ActiveRay* ray;
    std::uint32_t surface;
};

/// Rounds of the search for first hits; `any`: FirstHitSearch::any. In a round each active ray visits one node or leaf,
/// or a node and then a leaf below it, unless the leaf is to be fetched from memory first. A ray without a child to go
/// on with takes the top of its stack, and one that is done makes room for the next one.
template <bool any>
KERNEL_CODE void search_first(const TreeView& tree, const SurfaceTable& table, const FirstHitSearch& search)
{
    if (search.ray_count == 0)
        return;
    constexpr unsigned at_once = FirstHitSearch::at_once;
    Inverses inverses;
    find_inverses(search.batch, search.rays[search.ray_count - 1].number + std::size_t{1}, inverses);
    ActiveRay rays[at_once];
    ActiveRay* nodes[at_once + 1];
    ActiveRay* leaves[at_once + 1];
    ActiveRay* idle[at_once + 1];
    RayCandidate candidates[SurfaceBlock::lanes * at_once + 1];
    Hit hits[at_once];
    ActiveRay* rays_of_hits[at_once];
    alignas(64) float entry[WideNode::lanes];
    const SearchedRay* next = search.rays;
    const SearchedRay* const end = search.rays + search.ray_count;
    std::size_t node_count = 0;
    std::size_t leaf_count = 0;
    for (; next < end && node_count < at_once; ++node_count) {
        ActiveRay& ray = rays[node_count];
        ray.stack = search.stacks + node_count * search.stack_size;
        start_ray(search, inverses, *next++, ray);
        nodes[node_count] = &ray;
    }
    // Lists a ray that goes on with a child, if `is_met` is 1. Branch-free: stores to both lists, advances one.
    const auto visit = [&](ActiveRay* ray, std::uint32_t child, std::size_t is_met) {
        const std::size_t is_leaf = child / WideNode::leaf_flag;
        ray->next = child & ~WideNode::leaf_flag;
        nodes[node_count] = ray;
        leaves[leaf_count] = ray;
        node_count += is_met & (1 - is_leaf);
        leaf_count += is_met & is_leaf;
    };
    while (node_count + leaf_count > 0) {
        std::size_t idle_count = 0;
        for (std::size_t i = 0; tree.is_large && i < leaf_count; ++i)
            prefetch_all(tree.leaves[leaves[i]->next]);
        const std::size_t prefetched = leaf_count;
        const std::size_t nodes_now = node_count;
        node_count = 0;
        for (std::size_t i = 0; i < nodes_now; ++i) {
            ActiveRay* const ray = nodes[i];
            const WideNode& node = tree.nodes[ray->next];
            const unsigned met = boxes_met(node, ray->line, entry);
            // The branches of sorting take longer than visits to wrong children unless these wait for memory.
            if (any && !tree.is_large) {
                const auto child = [&](unsigned lane) { return std::uint64_t{node.child[lane]}; };
                const std::size_t others = add_lanes(met & (met - 1), ray->stack + ray->pending, child);
                ray->pending += static_cast<std::uint32_t>(others);
                visit(ray, node.child[first_lane(met)], some(met));
            } else {
                visit(ray, static_cast<std::uint32_t>(take_nearest(met, node, entry, tree.is_large, *ray)), some(met));
            }
            idle[idle_count] = ray;
            idle_count += 1 - some(met);
        }
        std::size_t candidate_count = 0;
        const std::size_t leaves_now = tree.is_large ? prefetched : leaf_count;
        for (std::size_t i = 0; i < leaves_now; ++i) {
            ActiveRay* const ray = leaves[i];
            const SurfaceBlock& leaf = tree.leaves[ray->next];
            idle[idle_count++] = ray;
            // A ray meets the surface it starts on, and its target if nothing is before it: both are decided already.
            const LeafTest test = any ? test_leaf<true>(leaf, ray->line, ray->from, ray->known)
                                      : test_leaf<false>(leaf, ray->line, ray->from);
            if (test.certain != 0)
                block(search, leaf.surface[first_lane(test.certain)], *ray);
            const unsigned met = test.certain == 0 ? test.met : 0;
            candidate_count += add_lanes(met, candidates + candidate_count, [&](unsigned lane) {
                prefetch_all(table.row(leaf.surface[lane]));
                return RayCandidate{ray, leaf.surface[lane]};
            });
        }
        leaf_count -= leaves_now;
        std::memmove(leaves, leaves + leaves_now, leaf_count * sizeof *leaves);
        for (std::size_t first = 0; first < candidate_count; first += at_once) {
            const std::size_t last = first + at_once < candidate_count ? first + at_once : candidate_count;
            std::size_t hit_count = 0;
            for (std::size_t i = first; i < last; ++i) {
                ActiveRay* const ray = candidates[i].ray;
                const std::uint32_t surface = candidates[i].surface;
                const bool is_met = decide(table, search.lines[ray->line.number], surface, hits[hit_count]);
                rays_of_hits[hit_count] = ray;
                hit_count += every(is_met, table.row(surface).plane() != ray->excluded_plane) ? 1 : 0;
            }
            for (std::size_t i = 0; i < hit_count; ++i)
                take_hit(search, hits[i], *rays_of_hits[i]);
        }
        for (std::size_t i = 0; i < idle_count; ++i) {
            ActiveRay* const ray = idle[i];
            const float length = ray->line.last - ray->line.first;
            std::uint32_t pending = ray->pending;
            while (pending > 0 && entry_of(ray->stack[pending - 1]) > length)
                --pending;
            if (pending > 0) {
                ray->pending = pending - 1;
                visit(ray, static_cast<std::uint32_t>(ray->stack[pending - 1]), 1);
            } else if (next < end) { // the ray is done: the next one takes its slot
                start_ray(search, inverses, *next++, *ray);
                visit(ray, 0, 1); // the root
            }
        }
    }
}

KERNEL_ENTRY void find_first(const TreeView& tree, const SurfaceTable& table, const FirstHitSearch& search)
{
    return search.any ? search_first<true>(tree, table, search) : search_first<false>(tree, table, search);
}

} // namespace
} // namespace LANE_SET
} // namespace multipath
