"""The principles of animation (FAQ Q1) as functions from a clip to a clip. KF9."""
