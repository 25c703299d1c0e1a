// Which detection belongs to which track, all at once: the cheapest assignment where only some pairs are
// possible and every row may stay alone at its own price.
//
//   minimise  sum over rows of  cost(row, its column)  or  alone(row);   no column twice
//
// Shortest augmenting paths with column potentials (Hungarian method in the form of Jonker and Volgenant,
// Computing 38, 1987), over lists of the possible pairs: a search touches only columns that compete, so that
// far-apart groups cost nothing to each other. O(n^3) when everything competes.
#pragma once

#include <cstddef>
#include <vector>

namespace bw::people {

class Assignment {
 public:
  /// Forgets the last problem; memory stays.
  void begin(std::size_t columns);

  /// The next row; `alone` is the price of leaving it without a column, any finite number.
  void add_row(double alone);

  /// The last row may take this column; each column at most once per row, any finite cost.
  void allow(std::size_t column, double cost);

  static constexpr int kAlone = -1;

  /// Column of each row, or kAlone. Valid until begin().
  const std::vector<int>& solve();

  /// Price of what solve() found.
  double total() const;

 private:
  struct Pair {
    int column;
    double cost;
  };
  struct Row {
    std::size_t first;  ///< of its pairs
    std::size_t end;
    double alone;
    double cost = 0.0;  ///< of its column
  };

  void place(int start);
  void reach(int row, double distance);
  void hand_over(int column, int start);

  std::vector<Pair> pairs_;
  std::vector<Row> rows_;
  std::vector<int> column_of_;
  std::vector<int> row_of_;        ///< of each column, -1: free
  std::vector<double> potential_;  ///< of each column
  std::vector<double> distance_;   ///< shortest known path to each column in this search
  std::vector<int> from_;          ///< row before the column on that path
  std::vector<char> finished_;     ///< whether the path to the column is final
  std::vector<int> touched_;       ///< columns with a path
  double give_up_distance_ = 0.0;  ///< shortest path that ends with a row left alone
  int give_up_row_ = -1;
};

}  // namespace bw::people
