package org.echoway.sdkless;

import com.android.apksig.ApkSigner;
import com.android.apksig.KeyConfig;
import com.android.apksig.apk.ApkFormatException;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.GeneralSecurityException;
import java.security.KeyStore;
import java.security.PrivateKey;
import java.security.cert.X509Certificate;
import java.util.List;

/** Signs with a debug key of this build folder, made when first needed: it protects nothing and is for tests alone. */
final class Signer {
    private static final String ALIAS = "debug";
    private static final String PASSWORD = "android";
    private final Path keyStore;

    Signer(Path keyStore) {
        this.keyStore = keyStore;
    }

    void sign(Path unsigned, Path signed, int minSdk) throws IOException, GeneralSecurityException, ApkFormatException {
        if (!Files.exists(keyStore)) makeKey();
        KeyStore store = KeyStore.getInstance("PKCS12");
        try (InputStream in = Files.newInputStream(keyStore)) {
            store.load(in, PASSWORD.toCharArray());
        }
        PrivateKey key = (PrivateKey) store.getKey(ALIAS, PASSWORD.toCharArray());
        X509Certificate certificate = (X509Certificate) store.getCertificate(ALIAS);
        var signer = new ApkSigner.SignerConfig.Builder("DEBUG", new KeyConfig.Jca(key), List.of(certificate)).build();
        new ApkSigner.Builder(List.of(signer))
                .setInputApk(unsigned.toFile()).setOutputApk(signed.toFile()).setMinSdkVersion(minSdk)
                .setV1SigningEnabled(false).setV2SigningEnabled(true).setV3SigningEnabled(true)
                .setAlignmentPreserved(true).build()
                .sign();
    }

    private void makeKey() throws IOException {
        String keytool = Path.of(System.getProperty("java.home"), "bin", "keytool").toString();
        Exec.run("making the debug key",
                List.of(keytool, "-genkeypair", "-keystore", keyStore.toString(), "-storetype", "PKCS12", "-storepass",
                        PASSWORD, "-keypass", PASSWORD, "-alias", ALIAS, "-keyalg", "RSA", "-keysize", "2048",
                        "-validity", "10000", "-dname", "CN=Echoway debug"));
    }
}
