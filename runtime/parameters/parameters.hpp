// Parameters from a struct's own field list: read, list, write. Example in field.hpp.
#pragma once

#include "runtime/parameters/list_parameters.hpp"
#include "runtime/parameters/read_parameters.hpp"
#include "runtime/parameters/write_parameters.hpp"
