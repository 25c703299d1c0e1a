// Sends readings of a type of its own over another vendor's DDS: waits for a reader, sends, waits until it has them all.
//   ROS_DOMAIN_ID=100 cyclone_sender
// Reading i (from 0) has the label "reading i" and 3 i bytes of data, byte j being i + j; the last one has 3,000,000 bytes.
#include <string.h>

#include "Reading.h"
#include "cyclone_common.h"

enum { kReadings = 10 };
static const uint32_t kLargest = 3000000;

int main(void) {
  const dds_entity_t participant = join_domain();
  const dds_entity_t topic =
      ros_topic(participant, &odd_msgs_msg_Reading_desc, "odd_msgs::msg::dds_::Reading_", "rt/readings");
  dds_qos_t* qos = dds_create_qos();
  dds_qset_reliability(qos, DDS_RELIABILITY_RELIABLE, DDS_SECS(10));
  dds_qset_history(qos, DDS_HISTORY_KEEP_LAST, kReadings);
  const dds_entity_t writer = checked(dds_create_writer(participant, topic, qos, NULL), "writer");
  dds_delete_qos(qos);

  dds_publication_matched_status_t matched = {0};
  for (const dds_time_t end = dds_time() + DDS_SECS(20); matched.current_count == 0 && dds_time() < end;) {
    checked(dds_get_publication_matched_status(writer, &matched), "matched");
    dds_sleepfor(DDS_MSECS(5));
  }
  if (matched.current_count == 0) {
    fprintf(stderr, "nobody reads\n");
    return 1;
  }
  uint8_t* bytes = malloc(kLargest);
  for (uint32_t i = 0; i < kReadings; ++i) {
    const uint32_t size = i + 1 < kReadings ? 3 * i : kLargest;
    for (uint32_t j = 0; j < size; ++j) bytes[j] = (uint8_t)(i + j);
    char label[32];
    snprintf(label, sizeof(label), "reading %u", i);
    odd_msgs_msg_Reading reading = {
        .number = i,
        .label = label,
        .data = {._maximum = size, ._length = size, ._buffer = bytes, ._release = false}};
    checked(dds_write(writer, &reading), "write");
  }
  checked(dds_wait_for_acks(writer, DDS_SECS(20)), "acknowledgements");
  free(bytes);
  dds_delete(DDS_CYCLONEDDS_HANDLE);
  return 0;
}
