#include "components/slam/graph_file.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "components/slam/graph_fields.hpp"
#include "components/slam/graph_io.hpp"

namespace bw::slam {
namespace {

using graph::Counts;
using graph::Fault;
using graph::fields;
using graph::kMagic;
using graph::kNone;
using graph::Reader;
using graph::Writer;

// Of a map from which submaps have left: whatever is followed from one to another must be there.
void check_marginalised(const Reader& reader, const SlamState& slam) {
  const std::vector<Submap>& submaps = slam.closing.submaps;
  const auto has_left = [&](std::size_t k) { return submaps[k].marginalised.has_value(); };
  const auto refuse_if = [&](bool wrong, const char* name, std::size_t number, const char* rule) {
    if (wrong) reader.refuse(name, std::to_string(number), rule);
  };
  for (const Submap& submap : submaps)
    if (const auto& anchor = submap.marginalised)
      refuse_if(has_left(anchor->submap), "anchor", anchor->submap, "must be a submap that is there");
  for (const auto& [number, node] : slam.nodes) {
    const std::size_t k = node.placement.submap;
    refuse_if(k < submaps.size() && has_left(k), "node", number, "must lie in a submap that is there");
  }
  // By edges of the drive, to the earliest submap of those that hang together.
  std::vector<std::size_t> earliest(submaps.size());
  std::iota(earliest.begin(), earliest.end(), std::size_t{0});
  const auto find = [&](std::size_t k) {
    while (earliest[k] != k) k = earliest[k] = earliest[earliest[k]];
    return k;
  };
  const auto check = [&](const Edge& edge) {
    for (const std::size_t end : {edge.from, edge.to})
      refuse_if(has_left(end), "end of an edge", end, "must be a submap that is there");
  };
  for (const Edge& edge : slam.closing.edges) {
    check(edge);
    if (edge.loop) continue;
    const auto [low, high] = std::minmax({find(edge.from), find(edge.to)});
    earliest[high] = low;
  }
  for (const Loop& loop : slam.closing.pending) {
    check(loop.edge);
    refuse_if(!loop.edge.loop, "loop", loop.edge.to, "must be marked as one");
  }
  std::optional<std::size_t> first;
  for (std::size_t k = 0; k < submaps.size(); ++k) {
    if (has_left(k)) continue;
    if (!first) first = find(k);
    refuse_if(find(k) != *first, "submap", k, "edges of the drive must lead to it");
  }
}

// The whole file but its first 20 bytes.
template <class Io>
void sections(Io& io, graph::Field<Io, SavedGraph> saved) {
  auto& slam = saved.slam;
  Counts counts{slam.closing.submaps.size(), slam.counts.nodes, 0};
  io.section("HEAD", [&] {
    fields(io, slam.options);
    fields(io, saved.X_MW, graph::kFarthest);
    io.integer("scans", slam.counts.scans, 0, graph::kMaxInteger);
    io.integer("unmatched", slam.counts.unmatched, 0, graph::kMaxInteger);
    if constexpr (Io::kReads) {
      io.index("submaps", counts.submaps, kNone);
      io.index("nodes", counts.nodes, kNone);
      slam.counts.nodes = counts.nodes;
    } else {
      io.index("submaps", counts.submaps, 0);
      io.index("nodes", counts.nodes, 0);
    }
  });
  io.section("SUBM", [&] {
    std::size_t k = 0;
    if constexpr (Io::kReads) {
      io.list_of("submaps", slam.closing.submaps, counts.submaps, graph::kSubmapBytes, [&](Submap& submap) {
        fields(io, submap, slam.closing.X_MS.emplace_back(), k++, counts);
        submap.all_round = all_round(submap.surfaces);
        submap.centre = centre(submap.surfaces);
      });
    } else {
      for (; k < counts.submaps; ++k) fields(io, slam.closing.submaps[k], slam.closing.X_MS[k], k, counts);
    }
  });
  io.section("TRCK", [&] { fields(io, slam.tracking, slam.options.resolution, counts); });
  counts.under_way = (slam.tracking.older ? 1U : 0U) + (slam.tracking.younger ? 1U : 0U);
  io.section("NODE", [&] {
    std::size_t next = 0;
    io.list("nodes", slam.nodes, graph::kNodeBytes, [&](auto& node) {
      io.index("number of a node", node.first, counts.nodes);
      if constexpr (Io::kReads) {
        if (node.first < next)
          io.refuse("number of a node", std::to_string(node.first), "must be above that of the one before");
      }
      next = node.first + 1;
      fields(io, node.second, counts);
    });
  });
  io.section("EDGE", [&] {
    io.list("edges", slam.closing.edges, graph::kEdgeBytes, [&](auto& edge) { fields(io, edge, counts); });
  });
  io.section("LOOP", [&] {
    io.list("loops that wait", slam.closing.pending, graph::kLoopBytes,
            [&](auto& loop) { fields(io, loop, counts); });
    fields(io, slam.closing.newest_in_first, 1e9);
    io.index("turn", slam.closing.turn, std::size_t{kNone} + 1);
    fields(io, slam.closing.counts);
    if constexpr (Io::kReads) check_marginalised(io, slam);
  });
}

}  // namespace

std::string graph_bytes(const SavedGraph& graph) {
  Writer writer;
  writer.raw(kMagic);
  writer.number(kGraphVersion);
  writer.number(std::uint64_t{0});
  sections(writer, graph);
  std::string bytes = writer.take();
  for (std::size_t i = 0; i < 8; ++i)
    bytes[12 + i] = static_cast<char>(std::uint64_t{bytes.size()} >> (8U * i));
  return bytes;
}

GraphReading read_graph(std::string_view bytes) {
  GraphReading reading;
  try {
    Reader reader(bytes);
    reader.header();
    sections(reader, reading.graph.emplace());
    reader.end();
  } catch (const Fault& fault) {
    reading.graph.reset();
    reading.fault = fault.sentence;
  }
  return reading;
}

}  // namespace bw::slam
