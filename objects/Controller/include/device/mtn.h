/*
 * Motion files (Hohl 2004, section 5.3.7).
 *
 * Motion files are in /MS/OPEN-R/MW/DATA/P and are named without this path: mtn_new("WALK.MTN").
 * All functions accept a null pointer.  It stands for a motion that has no length and is over.
 */

#ifndef DEVICE_MTN_H
#define DEVICE_MTN_H

#ifdef __cplusplus
extern "C" {
#endif

typedef struct MtnMotion MTN;

/* Loads a motion file; returns null on failure.  Lower case letters in the name are converted to
 * upper case. */
MTN *mtn_new(const char *filename);

/* Returns the reason why the last mtn_new() failed; null if it did not fail. */
const char *mtn_get_error(void);

/* Frees the memory of the motion; the file stays. */
void mtn_delete(MTN *mtn);

/* Plays the motion once. */
void mtn_play(MTN *mtn);

/* Returns the length of the motion, in ms. */
int mtn_get_length(MTN *mtn);

/* Returns the time since the beginning of the motion, in ms.  When the motion does not play,
 * returns its length. */
int mtn_get_time(MTN *mtn);

/* Returns 1 when the motion does not play or has ended, otherwise 0. */
int mtn_is_over(MTN *mtn);

#ifdef __cplusplus
}
#endif

#endif /* DEVICE_MTN_H */
