"""TRC: the tracks of optical markers (Motion Analysis), and the bones that they show. FF5, KF8."""
