#pragma once

#include <boost/asio/any_io_executor.hpp>
#include <boost/asio/thread_pool.hpp>
#include <functional>
#include <memory>
#include <stop_token>
#include <string>
#include <vector>

#include "tools/study/search/design_search.h"

namespace telepalp::study {

/// Who judges the linkages of the page.
struct JudgeSettings {
  int operators = 12;
  std::uint64_t seed = 1;
  int threads = 1;  ///< of a search
};

/// The threads of the program that compute for all pages: one for predictions, so that none waits for a search, and one
/// that leads the searches.
struct Workers {
  explicit Workers(const JudgeSettings& given) : settings(given) {}
  JudgeSettings settings;
  std::vector<Panel> panels;  ///< one operator each, made when first asked. Owner: the thread of `predictions`
  boost::asio::thread_pool predictions{1};
  boost::asio::thread_pool searches{1};
};

/// The predictions and the search that one page asked for. Owner: the network thread, on which `tell` is called with
/// each answer (answers.h). A new prediction ends the one before; the destructor ends all, and waits for nothing.
class Background {
 public:
  Background(Workers& workers, boost::asio::any_io_executor network, std::function<void(std::string)> tell);
  ~Background();
  Background(const Background&) = delete;
  Background& operator=(const Background&) = delete;

  void predict(const Configuration& design);
  /// Gives up the prediction that predict() began, because the linkage has changed.
  void forget_prediction() { prediction_.request_stop(); }
  void search(const SearchBox& box, int evaluations);
  /// Stops the search as soon as the linkage that it is judging is done. The page still gets what the search has found.
  void end_search() { search_.request_stop(); }

 private:
  using Tell = std::function<void(std::string)>;
  [[nodiscard]] std::function<void(std::string)> from_worker(std::stop_token stop) const;

  Workers& workers_;
  boost::asio::any_io_executor network_;
  std::shared_ptr<const Tell> tell_;  // shared: a worker's last answer may come when the page has left
  std::stop_source prediction_;
  std::stop_source search_;
};

}  // namespace telepalp::study
