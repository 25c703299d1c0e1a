// Boost's Asio and Beast, compiled once (BOOST_ASIO_SEPARATE_COMPILATION, BOOST_BEAST_SEPARATE_COMPILATION).
#include <utility>  // Asio 1.74 uses std::exchange without it

#include <boost/asio/impl/src.hpp>
#include <boost/beast/src.hpp>
