package com.hoho.android.usbserial.driver;

import android.hardware.usb.UsbDevice;

/** Knows no device: what this build packages cannot drive a belt. */
public class UsbSerialProber {
    public static UsbSerialProber getDefaultProber() {
        return new UsbSerialProber();
    }

    public UsbSerialDriver probeDevice(UsbDevice usbDevice) {
        return null;
    }
}
